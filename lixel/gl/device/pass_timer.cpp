// SPDX-License-Identifier: MIT
#include "lixel/gl/device/pass_timer.h"

#include "lixel/base/assert.h"

#include <epoxy/gl.h>

namespace lixel::gl {

void PassTimer::start()
{
    isOn_ = true;
    passes_.clear();
}

std::vector<PassTimer::Pass> PassTimer::stop()
{
    LX_ASSERT(isOn_);
    isOn_ = false;
    if (usesQueries_)
        for (std::size_t i = 0; i < passes_.size(); ++i) {
            GLuint64 nanoseconds = 0;
            glGetQueryObjectui64v(queries_[i].get(), GL_QUERY_RESULT, &nanoseconds);
            passes_[i].ms = double(nanoseconds) * 1e-6;
        }
    return passes_;
}

void PassTimer::begin(std::string_view name)
{
    // Debug groups name the pass in captures of a graphics debugger, timed or not.
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, GLsizei(name.size()), name.data());
    if (!isOn_) return;
    passes_.push_back({std::string(name), 0});
    if (usesQueries_) {
        if (queries_.size() < passes_.size()) queries_.push_back(makeTimerQuery());
        glBeginQuery(GL_TIME_ELAPSED, queries_[passes_.size() - 1].get());
    } else {
        glFinish();
        began_ = std::chrono::steady_clock::now();
    }
}

void PassTimer::end()
{
    glPopDebugGroup();
    if (!isOn_) return;
    if (usesQueries_) {
        glEndQuery(GL_TIME_ELAPSED);
        return;
    }
    glFinish();
    passes_.back().ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began_).count();
}

} // namespace lixel::gl
