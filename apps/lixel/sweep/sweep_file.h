// SPDX-License-Identifier: MIT
#pragma once

#include "shadows.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// The file of a sweep: all that `lixel study FILE.json` is to combine. docs/studies.md describes it for those who write one.
namespace lixel::app {

// Lights that a view is lit by together: its own, suns from everywhere above, or lights as a view file has them.
struct SweepLights
{
    std::string name;
    int suns = 0;
    std::vector<Light> lights;

    std::vector<Light> of(const std::vector<Light>& own, std::uint64_t seed) const;
};

struct SweepScene
{
    std::string text; // as the file has it
    std::string path; // what openScene() takes
    std::vector<std::string> views;
};

struct SweepFile
{
    std::filesystem::path path;
    std::string name, question;
    std::vector<SweepScene> scenes;
    std::vector<std::optional<double>> times; // nothing: the view file's, or 0
    std::vector<std::string> sizes;
    std::vector<SweepLights> lights;
    std::vector<TechniqueChoice> techniques;
    std::vector<LixelBudget> lixels;
    std::string executor;
    std::uint64_t seed = 0;
    int timingFrames = 0;
    std::string hash; // of what it says, and of the scenes, views and plans that it names

    std::filesystem::path folder() const { return path.parent_path(); } // where its relative paths begin
};

// Throws InputError, with file and place.
SweepFile readSweepFile(const std::filesystem::path& path);

// What is wrong with a name only the scene knows: InputError at a place of the file.
[[noreturn]] void refuseAt(const SweepFile& file, const std::string& place, const std::string& what);

// What a view of the file is to PictureOptions: a view file's path begins at the file's folder, a name stays.
std::string viewOption(const SweepFile& file, const std::string& view);

} // namespace lixel::app
