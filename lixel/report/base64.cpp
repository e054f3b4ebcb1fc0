// SPDX-License-Identifier: MIT
#include "lixel/report/base64.h"

#include <cstdint>

std::string lixel::toBase64(std::string_view bytes)
{
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        // Three bytes are four digits; what is missing at the end is padded.
        const auto byte = [&](std::size_t at) {
            return at < bytes.size() ? std::uint32_t(std::uint8_t(bytes[at])) : 0u;
        };
        const std::uint32_t bits = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
        for (unsigned digit = 0; digit < 4; ++digit)
            text += i + digit <= bytes.size() ? kDigits[bits >> (18 - 6 * digit) & 63] : '=';
    }
    return text;
}
