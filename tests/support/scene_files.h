// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace lixel::test {

// The folder of real scenes: LIXEL_SCENES, else ../shared/scenes beside the checkout. They are not part of the project.
std::filesystem::path sceneFolder();

// Tiny files of ours, one a loader feature.
std::filesystem::path dataFolder();

} // namespace lixel::test

// Leaves the test, saying so, where a real scene is not there.
#define LX_SKIP_WITHOUT_SCENE(file)                                                                                    \
    if (!std::filesystem::exists(::lixel::test::sceneFolder() / (file)))                                               \
    GTEST_SKIP() << "needs " << (file) << " in " << ::lixel::test::sceneFolder() << " (set LIXEL_SCENES)"
