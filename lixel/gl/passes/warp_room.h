// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/objects.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace lixel::gl {

// Device memory for what passes around warps need only while they run: one buffer for all of them, since none runs while another
// does. A pass lists its parts, makes room for them, and has them until the next one lists its own.
class WarpRoom
{
public:
    struct Part
    {
        std::size_t first = 0, bytes = 0;
    };

    // The parts of one run, side by side at offsets that every device binds storage at.
    class Parts
    {
    public:
        Part add(std::size_t bytes)
        {
            const Part part{bytes_, std::max(bytes, kLeast)};
            bytes_ += (part.bytes + kAlignment - 1) / kAlignment * kAlignment;
            return part;
        }
        std::size_t bytes() const { return bytes_; }

    private:
        static constexpr std::size_t kAlignment = 256; // the most that OpenGL lets a device ask for
        static constexpr std::size_t kLeast = 4;       // nothing at all cannot be bound
        std::size_t bytes_ = 0;
    };

    // Contents are lost. Throws GraphicsError where the device has no memory.
    void reserve(const Parts& parts) { buffer_.reserve(parts.bytes()); }
    void bindStorage(int binding, Part part) const { buffer_.bindStorage(binding, part.first, part.bytes); }
    void clear(Part part) { buffer_.clear(part.first, part.bytes); }

    std::uint32_t name() const { return buffer_.name(); }
    std::size_t bytes() const { return buffer_.capacity(); }

private:
    Buffer buffer_;
};

} // namespace lixel::gl
