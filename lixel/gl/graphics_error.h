// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace lixel::gl {

// No usable graphics, or the driver refused or failed at something: one clear line.
class GraphicsError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

} // namespace lixel::gl
