// SPDX-License-Identifier: MIT
#include "lixel/gl/device/readback_ring.h"

#include "lixel/base/assert.h"
#include "lixel/gl/graphics_error.h"

#include <epoxy/gl.h>

namespace lixel::gl {
namespace {

constexpr GLuint64 kSecond = 1'000'000'000; // nanoseconds

} // namespace

ReadbackRing::ReadbackRing(int age) : age_(age), slots_(std::size_t(age) + 1) { LX_ASSERT(age >= 0); }

ReadbackRing::~ReadbackRing()
{
    for (Slot& slot : slots_) removeFence(slot);
}

void ReadbackRing::removeFence(Slot& slot)
{
    if (slot.fence) glDeleteSync(static_cast<GLsync>(slot.fence));
    slot.fence = nullptr;
}

void ReadbackRing::clear()
{
    for (Slot& slot : slots_) removeFence(slot);
    pushes_ = 0;
}

void ReadbackRing::push(const Buffer& source, std::size_t bytes)
{
    Slot& slot = slots_[pushes_++ % slots_.size()];
    // Frames may have come and gone that nobody took.
    removeFence(slot);
    slot.buffer.reserve(bytes);
    slot.bytes = bytes;
    if (bytes > 0) glCopyNamedBufferSubData(source.name(), slot.buffer.name(), 0, 0, GLsizeiptr(bytes));
    slot.fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

void ReadbackRing::pushNothing()
{
    Slot& slot = slots_[pushes_++ % slots_.size()];
    removeFence(slot);
    slot.bytes = 0;
}

std::span<const std::byte> ReadbackRing::take()
{
    const auto age = std::uint64_t(age_);
    if (pushes_ <= age) return {};
    Slot& slot = slots_[(pushes_ - 1 - age) % slots_.size()];
    await(slot);
    return slot.buffer.bytes().first(slot.bytes);
}

void ReadbackRing::await(Slot& slot)
{
    if (!slot.fence) return; // taken before
    const auto fence = static_cast<GLsync>(slot.fence);
    GLenum state = glClientWaitSync(fence, 0, 0);
    if (state == GL_TIMEOUT_EXPIRED) ++waits_;
    while (state == GL_TIMEOUT_EXPIRED) state = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kSecond);
    if (state == GL_WAIT_FAILED) throw GraphicsError("the graphics device does not answer");
    removeFence(slot);
}

} // namespace lixel::gl
