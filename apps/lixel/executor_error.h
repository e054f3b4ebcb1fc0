// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace lixel::app {

// No usable OpenGL here; the message names --executor trace.
class NoGraphicsError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

} // namespace lixel::app
