// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/base/light.h"
#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/point_list.h"
#include "lixel/gl/passes/surfaces.h"
#include "lixel/gl/passes/view_targets.h"
#include "lixel/gl/passes/visibility_list.h"

#include <span>

namespace lixel::gl {

// Makes the picture by lixel/shared/shading.h.
//   reads   ViewTargets, Surfaces' materials, PointList with an entry a pixel, VisibilityList        writes   the picture
class ShadePass
{
public:
    static constexpr const char* kName = "shade";
    ShadePass();
    void run(const Surfaces& surfaces, const ViewTargets& targets, const PointList& points,
             const VisibilityList& visibility, std::span<const Light> lights);
    Image<Rgba8> download() const; // waits for the device; row 0 is the bottom

private:
    Program program_;
    Buffer lights_;
    Texture picture_;
};

} // namespace lixel::gl
