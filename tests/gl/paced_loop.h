// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/objects.h"

#include <functional>

namespace lixel::test {

// A frame loop that paces itself as one with a swap chain of two images does: before a frame is begun, the host waits until
// the device is done with the frame before the last, whose image it takes.
void runPaced(int frames, const std::function<void(int frame)>& drawFrame);

// Drawing that keeps the device busy for a time, without the host having to wait for it.
class DeviceDelay
{
public:
    DeviceDelay();
    void queue(int rounds) const; // some milliseconds a thousand rounds on a software driver

private:
    gl::Texture target_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray nothing_;
    gl::ProgramName program_;
};

} // namespace lixel::test
