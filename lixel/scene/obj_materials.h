// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lixel::obj {

// uv of the texture = scale * vt + offset (options -s and -o of map_Kd).
struct UvTransform
{
    Vec2d scale{1, 1}, offset{0, 0};
};

// Materials by name. The first of Scene::materials is grey, for faces without one.
struct Materials
{
    std::map<std::string, int, std::less<>> byName;
    std::vector<UvTransform> uv; // one a material
};

// Reads an MTL file's text into the scene: Kd, Ke, map_Kd, d or Tr, map_d; opaque unless d < 1 or map_d is there, then
// Mask with cutoff 0.5. map_d goes into the alpha of map_Kd. Images that cannot be had are left out with a warning.
void readMtl(std::string_view text, const std::string& file, const std::string& baseDirectory, Scene& scene,
             Materials& materials);

} // namespace lixel::obj
