// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/assert.h"

#include <array>
#include <cstddef>

namespace lixel {

// A vector with room for N values inside itself: what a frame's planning uses, so that it never allocates.
template <typename T, std::size_t N>
class FixedVector
{
public:
    void push_back(const T& value)
    {
        LX_ASSERT(size_ < N);
        values_[size_++] = value;
    }
    void clear() { size_ = 0; }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    static constexpr std::size_t capacity() { return N; }
    T& operator[](std::size_t i) { return values_[i]; }
    const T& operator[](std::size_t i) const { return values_[i]; }
    T* data() { return values_.data(); }
    const T* data() const { return values_.data(); }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }

private:
    std::array<T, N> values_;
    std::size_t size_ = 0;
};

} // namespace lixel
