// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/plan/shadow_plan.h"
#include "lixel/shared/lookup/stored_depths.h"

#include <cstdint>
#include <vector>

namespace lixel {

// All shadow maps of a plan, one image a layer.
using TracedAtlas = std::vector<Image<float>>;

// What a plan's lookup makes of its maps before anything is looked up; one image a layer of each that it needs.
struct PreparedMaps
{
    std::vector<Image<shared::LxWords>> words;
    std::vector<Image<std::uint32_t>> gradients;
    std::vector<Image<shared::vec4>> moments;
};

// By the functions of lixel/shared/lookup/, for every lixel that a region owns. Each region ends at its rectangle.
PreparedMaps prepareMaps(const FramePlan& plan, const TracedAtlas& atlas);

} // namespace lixel
