// SPDX-License-Identifier: MIT
#include "lixel/plan/technique_presets.h"

#include <array>

namespace lixel {
namespace {

struct Preset
{
    std::string_view name, words;
};

// Milet et al. 2015, sections 3.2 and 4. What neither they nor Rosen 2012 give as a number, the width of smoothing, is a 64th of the lines on
// either side: 17 of 512.
constexpr std::array<Preset, 4> kPresets{{
    {"rtw", "desired-view+rtw(importance=distance,analysis=backward,power=1,smooth=1/64,floor=0,raster=tessellate)"},
    {"now", "desired-view+now(importance=count,analysis=backward,power=1,smooth=1/64,floor=0,lines=nearest,"
            "raster=tessellate)"},
    {"now-dv", "desired-view"},
    {"min-sm", "minimal-frustum"},
}};

} // namespace

std::optional<std::string_view> presetNamed(std::string_view name)
{
    for (const Preset& preset : kPresets)
        if (preset.name == name) return preset.words;
    return std::nullopt;
}

} // namespace lixel
