// SPDX-License-Identifier: MIT
#include "lixel/scene/uri.h"

#include <gtest/gtest.h>

#include "lixel/scene/input_file.h"
#include "support/random_cases.h"

namespace lixel::test {
namespace {

std::string decoded(const std::string& base64)
{
    const auto bytes = decodeDataUri("data:text/plain;base64," + base64);
    if (!bytes) return "(none)";
    return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
}

TEST(DataUri, DecodesTheExamplesOfTheStandard) // RFC 4648, section 10
{
    EXPECT_EQ(decoded("Zg=="), "f");
    EXPECT_EQ(decoded("Zm8="), "fo");
    EXPECT_EQ(decoded("Zm9v"), "foo");
    EXPECT_EQ(decoded("Zm9vYmE="), "fooba");
    EXPECT_EQ(decoded("Zm9vYmFy"), "foobar");
    EXPECT_EQ(decoded("Zm9vYmE"), "fooba") << "padding may be left out";
}

TEST(DataUri, IsRefusedWhereItIsNotBase64)
{
    EXPECT_EQ(decoded(""), "(none)");
    EXPECT_EQ(decoded("Zm9v!"), "(none)");
    EXPECT_EQ(decoded("Zm9vY"), "(none)");
    EXPECT_EQ(decoded("Z=9v"), "(none)");
    EXPECT_FALSE(decodeDataUri("data:text/plain,foo"));
    EXPECT_FALSE(decodeDataUri("data:"));
}

TEST(DataUri, DecodingUndoesEncodingOfAnyBytes)
{
    forEachCase(kCases, [](Rng& rng) {
        std::string bytes(std::size_t(rng.integer(1, 40)), '\0');
        for (char& c : bytes) c = static_cast<char>(rng.integer(-128, 127));
        constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += 6) {
            unsigned digit = 0;
            for (std::size_t b = bit; b < bit + 6; ++b) {
                const unsigned byte = b / 8 < bytes.size() ? static_cast<unsigned char>(bytes[b / 8]) : 0;
                digit = digit << 1 | (byte >> (7 - b % 8) & 1u);
            }
            text += alphabet[digit];
        }
        while (text.size() % 4 != 0) text += '=';
        EXPECT_EQ(decoded(text), bytes);
    });
}

TEST(PercentDecoding, KnowsHexadecimalDigitsOnly)
{
    EXPECT_EQ(percentDecoded("a%20b%2Fc"), "a b/c");
    EXPECT_EQ(percentDecoded("plain.bin"), "plain.bin");
    EXPECT_EQ(percentDecoded("100%"), std::nullopt);
    EXPECT_EQ(percentDecoded("%2"), std::nullopt);
    EXPECT_EQ(percentDecoded("%zz"), std::nullopt);
    EXPECT_EQ(percentDecoded("%+1"), std::nullopt);
}

TEST(Utf8, OverlongSurrogateAndCutSequencesAreNone) // RFC 3629
{
    EXPECT_TRUE(isUtf8("plain, \xc3\xa9, \xe2\x82\xac, \xf0\x9f\x90\xb0"));
    for (const char* wrong :
         {"\xff", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xc3", "\xe2\x82", "\x80"})
        EXPECT_FALSE(isUtf8(wrong));
}

TEST(Messages, ShowNothingThatCannotBePrinted)
{
    EXPECT_EQ(printable("a\nb\x01\xff"), "a?b??");
    EXPECT_EQ(printable("caf\xc3\xa9"), "caf\xc3\xa9");
    EXPECT_LE(printable(std::string(500, 'x')).size(), 70u);
}

} // namespace
} // namespace lixel::test
