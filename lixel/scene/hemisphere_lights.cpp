// SPDX-License-Identifier: MIT
#include "lixel/scene/hemisphere_lights.h"

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

namespace lixel {

std::vector<Light> hemisphereLights(std::uint64_t seed, int count)
{
    std::mt19937_64 engine(seed);
    const auto unit = [&engine] { return double(engine() >> 11) * 0x1p-53; };
    std::vector<Light> lights;
    for (int i = 0; i < count; ++i) {
        // Zones of a sphere of equal height have equal areas (Archimedes).
        const double y = unit(), angle = 2 * std::numbers::pi * unit(), r = std::sqrt(1 - y * y);
        Light light;
        light.name = fmt::format("sun-{:03}", i);
        light.directionWorld = {-r * std::cos(angle), -y, -r * std::sin(angle)};
        lights.push_back(light);
    }
    return lights;
}

} // namespace lixel
