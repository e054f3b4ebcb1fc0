// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace lixel::app {

// What the command line ends with.
enum ExitCode {
    kDone = 0,
    kFailed = 1,
    kBadUsage = 2,
    kBadInput = 3,
    kNoGraphics = 4,
    kRefused = 5,
    kInterrupted = 130,
};

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
