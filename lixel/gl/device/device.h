// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/graphics_error.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace lixel::gl {

// What arrays that grow with samples, triangles or maps are split by, or refused by name.
struct DeviceLimits
{
    int textureSize = 0;                // texels a side
    int textureLayers = 0;              // of a 2D array
    int viewports = 0;                  // regions drawn in one call
    std::int64_t storageBlockBytes = 0; // one binding of a shader storage buffer
    std::int64_t storageAlignment = 0;  // offsets of such bindings are multiples of it
    std::int64_t uniformBlockBytes = 0;
    int workGroupsX = 0; // of one dispatch
};

// An OpenGL 4.5 core context with GL_ARB_shader_viewport_layer_array, on EGL without a window system or a display, or the
// one that a host has made current. It belongs to the thread that made it. A context of our own has synchronous debug
// output: errors and high-severity messages are collected.
class Device
{
public:
    enum class Context {
        Headless, // our own, destroyed with the device
        Current,  // the host's, current on this thread; its debug callback is left alone
    };

    // Throws GraphicsError where there is no such context; the message names `--executor trace`.
    explicit Device(Context context = Context::Headless);
    ~Device();
    Device(Device&&) noexcept;
    Device& operator=(Device&&) noexcept;

    // Every entry of the executor calls it: with several devices on one thread each finds its own context.
    void makeCurrent() const;

    const std::string& renderer() const;
    bool isSoftware() const; // then timer queries see next to nothing of a pass; see PassTimer
    const DeviceLimits& limits() const;
    void setLimits(const DeviceLimits& lower); // tests lower them, to see small arrays split

    // Errors and high-severity messages since the last call. A host's context only tells its error flags.
    std::vector<std::string> takeMessages() const;

    // Throws GraphicsError with the first message, if there is any: work of ours or of the host's callback has gone wrong.
    void throwOnMessages(const char* during) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lixel::gl
