// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// URIs as glTF uses them: bytes inside (RFC 2397, base64 of RFC 4648) or relative names (RFC 3986).
namespace lixel {

bool isDataUri(std::string_view uri);

// Nothing where the URI is not base64, or the base64 is broken or empty.
std::optional<std::vector<std::byte>> decodeDataUri(std::string_view uri);

// %20 becomes a space. Nothing where a '%' is not followed by two hexadecimal digits.
std::optional<std::string> percentDecoded(std::string_view uri);

} // namespace lixel
