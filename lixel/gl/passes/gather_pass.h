// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view.h"
#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/point_list.h"
#include "lixel/gl/passes/surfaces.h"
#include "lixel/gl/passes/view_targets.h"

namespace lixel::gl {

// Makes the list of view samples, one entry a pixel: where the ray through the pixel's centre meets the triangle seen there,
// in double precision, with the triangle's normal turned to the eye.
//   reads   ViewTargets::triangles, Surfaces        writes   PointList
class GatherPass
{
public:
    static constexpr const char* kName = "gather";
    GatherPass();
    void run(const Surfaces& surfaces, const View& view, const ViewTargets& targets, PointList& points);

private:
    Program program_;
    Buffer rays_;
};

// The rays of a view for lixel/shared/view_tables.h.
shared::ViewRays raysOf(const View& view, Vec3d originWorld);

} // namespace lixel::gl
