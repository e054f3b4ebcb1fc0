// SPDX-License-Identifier: MIT
#include "lixel/scene/uri.h"

#include <array>
#include <charconv>
#include <cstdint>

namespace lixel {
namespace {

constexpr std::uint8_t kNoDigit = 64;

constexpr std::array<std::uint8_t, 256> base64Digits()
{
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<std::uint8_t, 256> digits{};
    digits.fill(kNoDigit);
    for (std::size_t i = 0; i < alphabet.size(); ++i) digits[static_cast<unsigned char>(alphabet[i])] = std::uint8_t(i);
    return digits;
}

} // namespace

bool isDataUri(std::string_view uri) { return uri.starts_with("data:"); }

std::optional<std::vector<std::byte>> decodeDataUri(std::string_view uri)
{
    static constexpr auto kDigits = base64Digits();
    const std::size_t comma = uri.find(',');
    if (comma == uri.npos || !uri.substr(0, comma).ends_with(";base64")) return std::nullopt;
    std::string_view text = uri.substr(comma + 1);
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
    if (text.empty() || text.size() % 4 == 1) return std::nullopt;

    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int bitCount = 0;
    for (const char c : text) {
        const std::uint8_t digit = kDigits[static_cast<unsigned char>(c)];
        if (digit == kNoDigit) return std::nullopt;
        bits = (bits << 6 | digit) & 0xffffffu;
        bitCount += 6;
        if (bitCount >= 8) {
            bitCount -= 8;
            bytes.push_back(std::byte(bits >> bitCount & 0xffu));
        }
    }
    return bytes;
}

std::optional<std::string> percentDecoded(std::string_view uri)
{
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            text += uri[i];
            continue;
        }
        unsigned value = 0;
        if (i + 3 > uri.size()) return std::nullopt;
        const char* const last = uri.data() + i + 3;
        const auto [end, error] = std::from_chars(uri.data() + i + 1, last, value, 16);
        if (error != std::errc{} || end != last) return std::nullopt;
        text += static_cast<char>(value);
        i += 2;
    }
    return text;
}

} // namespace lixel
