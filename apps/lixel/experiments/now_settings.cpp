// SPDX-License-Identifier: MIT
#include "experiments/now_settings.h"

#include <filesystem>

#include <fmt/format.h>

namespace lixel::app {
namespace {

// A spot has a place and a way, a sun a way, a point light a place.
struct Setting
{
    const char *eye, *target, *lightPosition, *lightDirection;
    double lightAngle; // degrees
};

PictureOptions pictureOf(const std::string& scene, const Setting& s, const std::string& size)
{
    PictureOptions picture;
    picture.scene = scene;
    picture.size = size;
    picture.flags.eye = s.eye;
    picture.flags.target = s.target;
    if (*s.lightPosition) picture.flags.lightPosition = s.lightPosition;
    if (*s.lightDirection) picture.flags.lightDirection = s.lightDirection;
    if (s.lightAngle > 0) picture.flags.lightAngle = s.lightAngle;
    return picture;
}

// Along the table, under a lamp at the ceiling; across the chairs, with a lamp in the far corner; the whole room under the first.
constexpr std::array<Setting, 3> kConference{{{"4.3,1.5,1.6", "0,0.5,-0.8", "1,1.9,-0.6", "0,-1,0", 140},
                                              {"-2.5,1.4,-2.6", "3,0.4,0.6", "4.5,1.8,1.5", "-1,-0.5,-0.6", 110},
                                              {"1,1.2,1.7", "1,0.4,-1", "-2,1.7,-2.4", "0.8,-0.6,0.6", 110}}};

// Down the nave in the sun; along the aisle, with the lamp behind the curtains; from the gallery, with a lamp over the open roof; from
// outside in the sun.
constexpr std::array<Setting, 4> kSponza{{{"-14,1,0", "10,3.5,0", "", "0.2,-1,0.3", 0},
                                          {"12,2,5", "-10,2.5,4.6", "4,7,0", "-0.4,-1,0.6", 100},
                                          {"-13,6.2,-4", "10,5,-1", "0,22,0", "", 0},
                                          {"-30,22,24", "0,4,0", "", "0.5,-1,-0.4", 0}}};

constexpr std::array<const char*, 5> kCityViews{"street", "crossing", "skyline", "light-in-frustum", "light-at-eye"};

} // namespace

std::vector<NowScene> nowScenes(const ExperimentOptions& options, std::string& leftOut)
{
    const std::string size = options.isQuick ? "256x256" : "1024x1024";
    std::vector<NowScene> scenes;
    const auto addFile = [&](const char* paperName, const char* name, std::span<const Setting> settings) {
        const std::filesystem::path file = options.scenes / name;
        if (options.scenes.empty() || !std::filesystem::exists(file)) {
            leftOut += fmt::format("{}{}", leftOut.empty() ? "" : ", ", name);
            return;
        }
        NowScene scene{paperName, file.string(), {}};
        for (const Setting& s : settings) scene.pictures.push_back(pictureOf(scene.file, s, size));
        scenes.push_back(scene);
    };
    addFile("Conf. room", "conference.glb", kConference);
    addFile("Sponza", "sponza_crytek.glb", kSponza);
    NowScene city{"Observatory", "city", {}};
    for (const char* view : kCityViews) {
        PictureOptions picture;
        picture.scene = city.file;
        picture.view = view;
        picture.size = size;
        city.pictures.push_back(picture);
    }
    scenes.push_back(city);
    return scenes;
}

} // namespace lixel::app
