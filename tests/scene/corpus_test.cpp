// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene/loaded.h"

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

// As the fuzzer has it, which chooses by the first bytes.
Scene loadBytes(const std::string& bytes)
{
    if (bytes.starts_with("glTF") || bytes.starts_with("{"))
        return loadGltf(std::as_bytes(std::span(bytes)), "corpus", "");
    return loadObj(bytes, "corpus", "");
}

// What the fuzzer once found interesting, and all small files of ours: a scene that can be drawn, or an InputError.
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
            const auto scene = std::make_shared<const Scene>(loadBytes(bytes));
            for (const double time : {0.0, 0.5, 1e6}) {
                const SceneBuffers buffers = evaluate(scene, {time, 0}, {});
                for (const Vec3f& p : buffers.triangles.positionLocal) EXPECT_TRUE(isFinite(toDouble(p)));
                for (const std::uint32_t i : buffers.triangles.indices)
                    EXPECT_LT(i, buffers.triangles.positionLocal.size());
            }
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
