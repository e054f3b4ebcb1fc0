// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/objects.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lixel::gl {

// Data of every frame on its way from the device to the host, which gets that of exactly `age` frames before: never what
// happens to have arrived, so that nothing depends on timing. One buffer a frame under way, mapped for good, each with a fence.
//
// A frame is one push() and one take(). A loop that lets the host run no more than `age` frames ahead of the device, as one
// does that waits for an image of a swap chain, finds every fence signalled.
class ReadbackRing
{
public:
    explicit ReadbackRing(int age = 2); // 0: of the frame itself, which take() then waits for
    ~ReadbackRing();
    ReadbackRing(const ReadbackRing&) = delete;
    ReadbackRing& operator=(const ReadbackRing&) = delete;

    // Queues a copy of the buffer's first bytes, as they are when all that was asked of the device before is done.
    void push(const Buffer& source, std::size_t bytes);
    void pushNothing(); // a frame that has no data

    // What was pushed `age` frames before the last push; nothing as long as there was none. Valid until the next push.
    // Waits where it must. Throws GraphicsError where the device is lost.
    std::span<const std::byte> take();

    void clear(); // as if nothing had been pushed yet
    int age() const { return age_; }
    std::uint64_t waits() const { return waits_; } // takes that met a fence which was not signalled yet

private:
    struct Slot
    {
        MappedBuffer buffer;
        std::size_t bytes = 0;
        void* fence = nullptr; // a GLsync; OpenGL has none that can be used again
    };
    static void removeFence(Slot& slot);
    void await(Slot& slot);

    int age_ = 0;
    std::vector<Slot> slots_;
    std::uint64_t pushes_ = 0, waits_ = 0; // pushes since clear()
};

} // namespace lixel::gl
