// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace lixel::app {

// What the command line ends with: its exit codes.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kBadUsage = 2;
inline constexpr int kBadInput = 3;
inline constexpr int kNoGraphics = 4;
inline constexpr int kRefused = 5;
inline constexpr int kInterrupted = 130;

// Bad usage that only shows once the words are understood: an unknown view, a size of zero.
class UsageError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

// No technique could serve what was asked.
class RefusedError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

} // namespace lixel::app
