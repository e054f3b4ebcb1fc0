// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "fuzz/load_bytes.h"
#include "support/scene_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace lixel::test {
namespace {

std::vector<std::filesystem::path> filesBelow(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// What the fuzzer once found interesting, and all small files of ours, as the fuzzer runs them: a scene that can be drawn, or an
// InputError.
TEST(Corpus, EveryFileIsAFiniteSceneOrRefused)
{
    std::vector<std::filesystem::path> files =
        filesBelow(std::filesystem::path(LIXEL_SOURCE_DIR) / "tests/fuzz/corpus");
    ASSERT_FALSE(files.empty());
    const std::vector<std::filesystem::path> data = filesBelow(dataFolder());
    files.insert(files.end(), data.begin(), data.end());
    int scenes = 0, refusals = 0;
    for (const std::filesystem::path& path : files) {
        SCOPED_TRACE(path.string());
        std::ifstream stream(path, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        try {
            EXPECT_EQ(wrongWhenLoaded(bytes), "");
            ++scenes;
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            ++refusals;
        }
    }
    EXPECT_GT(scenes, 10);
    EXPECT_GT(refusals, 10);
}

} // namespace
} // namespace lixel::test
