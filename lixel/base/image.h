// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/assert.h"

#include <cstddef>
#include <vector>

namespace lixel {

// A grid of values. Row 0 is the bottom, as in GL; files have the top first, and writers turn it.
template <typename T>
class Image
{
public:
    Image() = default;
    Image(int width, int height, T value = T{}) : width_(width), height_(height)
    {
        LX_ASSERT(width >= 0 && height >= 0);
        data_.assign(std::size_t(width) * std::size_t(height), value);
    }

    int width() const { return width_; }
    int height() const { return height_; }
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
    T& operator()(int x, int y) { return data_[std::size_t(y) * std::size_t(width_) + std::size_t(x)]; }
    const T& operator()(int x, int y) const { return data_[std::size_t(y) * std::size_t(width_) + std::size_t(x)]; }
    std::vector<T>& data() { return data_; }
    const std::vector<T>& data() const { return data_; }

private:
    int width_ = 0, height_ = 0;
    std::vector<T> data_;
};

} // namespace lixel
