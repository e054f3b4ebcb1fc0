// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace lixel {

// RFC 4648, section 4: with padding, without line breaks.
std::string toBase64(std::string_view bytes);

} // namespace lixel
