// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/assert.h"

#include <optional>
#include <utility>
#include <variant>

namespace lixel {

// A value, or the reason why there is none. For answers that may not exist (a fit, an intersection, a parse); bad input
// files throw at the edge, our own mistakes assert.
template <typename E>
struct Unexpected
{
    E error;
};
template <typename E>
Unexpected(E) -> Unexpected<E>;

template <typename T, typename E>
class Expected
{
public:
    Expected(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Expected(Unexpected<E> unexpected) : state_(std::in_place_index<1>, std::move(unexpected.error)) {}

    bool hasValue() const { return state_.index() == 0; }
    explicit operator bool() const { return hasValue(); }

    // Needs hasValue().
    const T& value() const&
    {
        LX_ASSERT(hasValue());
        return *std::get_if<0>(&state_);
    }
    T& value() &
    {
        LX_ASSERT(hasValue());
        return *std::get_if<0>(&state_);
    }
    T&& value() &&
    {
        LX_ASSERT(hasValue());
        return std::move(*std::get_if<0>(&state_));
    }
    const T& operator*() const& { return value(); }
    T& operator*() & { return value(); }
    const T* operator->() const { return &value(); }
    T* operator->() { return &value(); }

    // Needs !hasValue().
    const E& error() const
    {
        LX_ASSERT(!hasValue());
        return *std::get_if<1>(&state_);
    }

private:
    std::variant<T, E> state_;
};

} // namespace lixel
