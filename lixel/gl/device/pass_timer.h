// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/device.h"
#include "lixel/gl/device/objects.h"

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace lixel::gl {

// How long the passes of a frame take, each under its own name. On software drivers timer queries see next to nothing of a
// pass, so there it is glFinish and the steady clock on both sides; elsewhere timer queries. Off by default: then it does
// nothing, and the frame is undisturbed.
class PassTimer
{
public:
    struct Pass
    {
        std::string name;
        double ms = 0;
    };

    // Times the pass as long as it lives. Scopes do not nest.
    class Scope
    {
    public:
        Scope(PassTimer& timer, std::string_view name) : timer_(timer) { timer_.begin(name); }
        ~Scope() { timer_.end(); }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

    private:
        PassTimer& timer_;
    };

    explicit PassTimer(const Device& device) : usesQueries_(!device.isSoftware()) {}

    // Starts or ends the watch; a frame's passes are those since the start, in the order they ran.
    void start();
    std::vector<Pass> stop(); // waits for the device

    const char* clock() const { return usesQueries_ ? "GL_TIME_ELAPSED" : "glFinish + steady_clock"; }

private:
    void begin(std::string_view name);
    void end();

    bool usesQueries_ = false;
    bool isOn_ = false;
    std::vector<Pass> passes_;
    std::vector<Query> queries_; // one a pass, kept for the next frame
    std::chrono::steady_clock::time_point began_;
};

} // namespace lixel::gl
