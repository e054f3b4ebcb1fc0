// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/assert.h"

#include <cstddef>
#include <initializer_list>
#include <new>
#include <type_traits>

namespace lixel {

// A vector with room for N values inside itself: what a frame's planning uses, so that it never allocates. Making and
// copying one costs what it holds, not what it has room for.
template <typename T, std::size_t N>
class FixedVector
{
    static_assert(std::is_copy_constructible_v<T> && std::is_trivially_destructible_v<T>);

public:
    FixedVector() {} // leaves the room as it is
    FixedVector(std::initializer_list<T> values)
    {
        for (const T& value : values) push_back(value);
    }
    FixedVector(const FixedVector& other) { append(other); }
    FixedVector& operator=(const FixedVector& other)
    {
        if (this != &other) {
            clear();
            append(other);
        }
        return *this;
    }
    ~FixedVector() = default;

    void push_back(const T& value)
    {
        LX_ASSERT(size_ < N);
        ::new (static_cast<void*>(room_ + size_ * sizeof(T))) T(value);
        ++size_;
    }
    void pop_back()
    {
        LX_ASSERT(size_ > 0);
        --size_;
    }
    void clear() { size_ = 0; }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    static constexpr std::size_t capacity() { return N; }
    T& operator[](std::size_t i) { return data()[i]; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    T& back() { return data()[size_ - 1]; }
    const T& back() const { return data()[size_ - 1]; }
    T* data() { return reinterpret_cast<T*>(room_); }
    const T* data() const { return reinterpret_cast<const T*>(room_); }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }

private:
    void append(const FixedVector& other)
    {
        for (const T& value : other) push_back(value);
    }

    alignas(T) std::byte room_[N * sizeof(T)];
    std::size_t size_ = 0;
};

} // namespace lixel
