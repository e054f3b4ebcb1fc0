// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/view_pass.h"

#include "lixel/base/assert.h"
#include "lixel/gl/device/draw_state.h"
#include "lixel/plan/clip_convention.h"
#include "lixel/plan/shadow_plan.h"

#include <epoxy/gl.h>

#include <array>
#include <string>

namespace lixel::gl {
namespace {

// Locations in surface.vert.glsl, surface.frag.glsl and alpha.glsl.
constexpr int kClipFromLocal = 0, kFirstTriangle = 1, kSurfaceWrap = 8;

void clear(const ViewTargets& targets)
{
    const GLuint framebuffer = targets.framebuffer.name();
    const std::array<GLuint, 4> nothing{0xffffffffu, 0, 0, 0};
    const std::array<GLfloat, 4> black{};
    const GLfloat far = 0;
    glClearNamedFramebufferuiv(framebuffer, GL_COLOR, 0, nothing.data());
    glClearNamedFramebufferfv(framebuffer, GL_COLOR, 1, black.data());
    glClearNamedFramebufferfv(framebuffer, GL_COLOR, 2, black.data());
    glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &far);
}

} // namespace

ViewPass::ViewPass() : opaque_(Program::graphics({"surface.vert.glsl", "surface.frag.glsl"}))
{
    const std::array<std::string, 1> masked{"MASKED"};
    masked_ = Program::graphics({"surface.vert.glsl", "surface.frag.glsl"}, masked);
}

void ViewPass::run(const Surfaces& surfaces, const View& view, const ViewTargets& targets) const
{
    LX_ASSERT(targets.triangles.width() == view.width && targets.triangles.height() == view.height);
    apply(DrawState{});
    clear(targets);
    targets.framebuffer.bind();
    glViewport(0, 0, view.width, view.height);

    const shared::mat4 clip = toShared(toHost(clipFromLocal(view, surfaces.originWorld()), kExecutorConvention));
    for (const Program* program : {&opaque_, &masked_})
        glProgramUniformMatrix4fv(program->name(), kClipFromLocal, 1, GL_FALSE, &clip.columns[0].x);
    surfaces.bindVertices();
    if (surfaces.triangleCount() > 0) surfaces.bindMaterials();
    for (const DrawRange& range : surfaces.ranges()) {
        const Program& program = range.isMasked ? masked_ : opaque_;
        const Surfaces::Wraps wraps = surfaces.bindTexture(range);
        program.set(kFirstTriangle, range.firstTriangle);
        if (range.isMasked) program.set(kSurfaceWrap, wraps.u, wraps.v);
        program.use();
        surfaces.draw(range.firstTriangle, range.triangleCount);
    }
}

} // namespace lixel::gl
