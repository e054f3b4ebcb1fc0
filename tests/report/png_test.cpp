// SPDX-License-Identifier: MIT
#include "lixel/report/png.h"

#include "lixel/report/write_file.h"
#include "sample_results.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>
#include <iterator>

namespace lixel::test {
namespace {

enum ColourType { Rgb = 2, Palette = 3, Rgba = 6 };

// PNG (W3C), 11.2.2: the header chunk's data starts at byte 16; width, height, bit depth, colour type.
ColourType colourTypeOf(const std::string& png) { return ColourType(png.at(25)); }

Image<Rgba8> randomPicture(Rng& rng, int width, int height, int colours, bool isOpaque)
{
    const auto byte = [&] { return std::uint8_t(rng.integer(0, 255)); };
    std::vector<Rgba8> palette;
    for (int i = 0; i < colours; ++i)
        palette.push_back({byte(), byte(), byte(), isOpaque ? std::uint8_t(255) : byte()});
    Image<Rgba8> picture(width, height);
    for (Rgba8& pixel : picture.data()) pixel = palette[std::size_t(rng.integer(0, colours - 1))];
    return picture;
}

TEST(Png, EveryPictureReadsBackTheSame)
{
    forEachCase(kCases, [](Rng& rng) {
        const int width = rng.integer(1, 40), height = rng.integer(1, 40);
        const auto picture =
            randomPicture(rng, width, height, rng.chance(0.5) ? rng.integer(1, 20) : 2000, rng.chance(0.5));
        const Image<Rgba8> back = decodePng(encodePng(picture), "picture");
        ASSERT_EQ(back.width(), width);
        ASSERT_EQ(back.height(), height);
        ASSERT_EQ(back.data(), picture.data());
    });
}

TEST(Png, IsStoredAsTheLeastThatHoldsIt)
{
    Rng rng(1);
    EXPECT_EQ(colourTypeOf(encodePng(randomPicture(rng, 64, 64, 256, false))), Palette);
    EXPECT_EQ(colourTypeOf(encodePng(randomPicture(rng, 64, 64, 2000, true))), Rgb);
    EXPECT_EQ(colourTypeOf(encodePng(randomPicture(rng, 64, 64, 2000, false))), Rgba);
}

// A file made by hand from the standard: 1 x 2, grey, the first scan line white, the second black.
TEST(Png, FirstLineOfAFileIsTheTopRow)
{
    constexpr unsigned char kWhiteOverBlack[] = {
        0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
        0x00, 0x01, 0x00, 0x00, 0x00, 0x02, 0x08, 0x00, 0x00, 0x00, 0x00, 0xbc, 0xea, 0xe9, 0xfb, 0x00, 0x00, 0x00,
        0x0c, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0xf8, 0xcf, 0xc0, 0x00, 0x00, 0x03, 0x01, 0x01, 0x00, 0xc9,
        0xfe, 0x92, 0xef, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
    const std::string bytes(std::begin(kWhiteOverBlack), std::end(kWhiteOverBlack));
    const Image<Rgba8> picture = decodePng(bytes, "picture");
    EXPECT_EQ(picture(0, 1), (Rgba8{255, 255, 255, 255}));
    EXPECT_EQ(picture(0, 0), (Rgba8{0, 0, 0, 255}));
}

TEST(Png, SameBytesForTheSamePicture)
{
    Rng rng(2);
    const auto picture = randomPicture(rng, 50, 30, 100, false);
    EXPECT_EQ(encodePng(picture), encodePng(picture));
}

TEST(Png, FileHoldsTheEncodedBytes)
{
    const TemporaryFolder folder;
    const Image<Rgba8> picture(3, 2, {1, 2, 3, 255});
    writePng(folder.path() / "a.png", picture);
    EXPECT_EQ(readWhole(folder.path() / "a.png"), encodePng(picture));
    EXPECT_EQ(readPng(folder.path() / "a.png").data(), picture.data());
}

TEST(Png, TruncatedOrForeignBytesAreRefusedInOneLine)
{
    Rng rng(3);
    const std::string whole = encodePng(randomPicture(rng, 40, 40, 2000, true));
    for (const std::string& bytes :
         {whole.substr(0, whole.size() / 2), whole.substr(0, 10), std::string("GIF89a"), std::string()})
        try {
            decodePng(bytes, "the.png");
            ADD_FAILURE() << "accepted " << bytes.size() << " bytes";
        } catch (const std::runtime_error& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.rfind("the.png: not a PNG file that can be read: ", 0), 0u) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos);
        }
}

} // namespace
} // namespace lixel::test
