// SPDX-License-Identifier: MIT
#include "lixel/report/exr.h"

#include "lixel/report/write_file.h"
#include "sample_results.h"
#include "support/random_cases.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>

namespace lixel::test {
namespace {

std::vector<float> randomValues(Rng& rng, std::size_t count)
{
    std::vector<float> values(count);
    for (float& value : values) value = float(rng.uniform(-1, 1) * rng.logUniform(1e-30, 1e30));
    return values;
}

bool sameBits(const std::vector<float>& a, const std::vector<float>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

TEST(Exr, EveryBitReadsBackTheSame)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "picture.exr";
    forEachCase(kCases, [&](Rng& rng) {
        const int width = rng.integer(1, 40), height = rng.integer(1, 40);
        std::map<std::string, std::vector<float>> expected;
        for (const char* name : {"position.X", "position.Y", "position.Z", "depth.Z", "visibility.sun.V"})
            expected[name] = randomValues(rng, std::size_t(width * height));
        expected["depth.Z"][0] = std::numeric_limits<float>::infinity();
        expected["position.X"][0] = std::numeric_limits<float>::quiet_NaN();
        std::vector<ExrChannel> channels;
        for (const auto& [name, values] : expected) channels.push_back({name, values});
        const Vec3d originWorld = 1e5 * rng.inBox(1);

        writeExr(path, width, height, channels, originWorld);
        const ExrPicture back = readExr(path);
        ASSERT_EQ(back.width, width);
        ASSERT_EQ(back.height, height);
        ASSERT_EQ(back.originWorld, originWorld);
        ASSERT_EQ(back.channels.size(), expected.size());
        for (const auto& [name, values] : expected) ASSERT_TRUE(sameBits(back.channels.at(name), values)) << name;
    });
}

// As another program sees it, without our reader.
TEST(Exr, BottomRowIsTheLastOfTheFile)
{
    const TemporaryFolder folder;
    const std::vector<float> values{1, 2, 3, 4, 5, 6}; // two wide; the bottom row is 1, 2
    writeExr(folder.path() / "a.exr", 2, 3, std::vector<ExrChannel>{{"depth.Z", values}}, {});

    Imf::InputFile file((folder.path() / "a.exr").c_str());
    EXPECT_EQ(file.header().channels().findChannel("depth.Z")->type, Imf::FLOAT);
    std::vector<float> rows(6);
    Imf::FrameBuffer frame;
    frame.insert("depth.Z", {Imf::FLOAT, reinterpret_cast<char*>(rows.data()), sizeof(float), 2 * sizeof(float)});
    file.setFrameBuffer(frame);
    file.readPixels(0, 2);
    EXPECT_EQ(rows, (std::vector<float>{5, 6, 3, 4, 1, 2}));
}

TEST(Exr, SameBytesForTheSamePicture)
{
    const TemporaryFolder folder;
    const std::vector<float> values(100, 0.25f);
    for (const char* name : {"a.exr", "b.exr"})
        writeExr(folder.path() / name, 10, 10, std::vector<ExrChannel>{{"visibility.V", values}}, {1, 2, 3});
    EXPECT_EQ(readWhole(folder.path() / "a.exr"), readWhole(folder.path() / "b.exr"));
}

TEST(Exr, TruncatedOrForeignFilesAreRefusedByName)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.exr";
    writeExr(path, 10, 10, std::vector<ExrChannel>{{"visibility.V", std::vector<float>(100, 1.0f)}}, {});
    const std::string whole = readWhole(path);
    for (const std::string& bytes : {whole.substr(0, 20), std::string("no picture"), std::string()}) {
        writeFileAtomically(path, bytes);
        try {
            readExr(path);
            ADD_FAILURE() << "accepted " << bytes.size() << " bytes";
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(std::string(error.what()).rfind(path.string() + ": not an OpenEXR file", 0), 0u) << error.what();
        }
    }
}

} // namespace
} // namespace lixel::test
