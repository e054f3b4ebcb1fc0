// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/gl/passes/light_depth_pass.h"

#include <vector>

namespace lixel::gl {

// What the lixels of a plan's maps really sample: the light depth pass with one attachment more.
//   reads   PlanTables, Surfaces without holes        writes   an atlas of its own
class DrawnPositions
{
public:
    explicit DrawnPositions(const Device& device) : pass_(device, LightDepthPass::Output::DepthAndPosition) {}

    void run(const Device& device, const FramePlan& plan, const PlanTables& tables, const Surfaces& casters);
    // One image a layer: the Local position of the surface in each lixel with w = 1; w = 0 where nothing is. Waits for the device.
    std::vector<Image<Vec4f>> download(int layers) const;

private:
    LightDepthPass pass_;
    ShadowAtlas atlas_;
    Texture positions_;
};

} // namespace lixel::gl
