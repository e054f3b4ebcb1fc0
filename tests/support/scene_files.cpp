// SPDX-License-Identifier: MIT
#include "support/scene_files.h"

#include <cstdlib>

namespace lixel::test {

std::filesystem::path sceneFolder()
{
    if (const char* folder = std::getenv("LIXEL_SCENES")) return folder;
    return std::filesystem::path(LIXEL_SOURCE_DIR) / ".." / "shared" / "scenes";
}

std::filesystem::path dataFolder() { return std::filesystem::path(LIXEL_SOURCE_DIR) / "tests" / "data"; }

} // namespace lixel::test
