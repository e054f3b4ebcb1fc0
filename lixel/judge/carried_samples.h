// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/caster_source.h"
#include "lixel/base/view.h"
#include "lixel/base/view_samples.h"

#include <cstdint>
#include <span>
#include <vector>

// The same surface points a frame later. When the camera moves, a pixel shows other points than before; whether a shadow
// is steady can only be asked of points that stay on their surface.
namespace lixel {

struct CarriedSamples
{
    ViewSamples samples;             // at their new place; `pixel` is where the new view has them, no pixel's centre
    std::vector<std::uint32_t> from; // of each, its index among the samples it was carried from
};

// The samples that the view of the frame now still has in its frustum, on the side of their surface that it looks at.
//
//   Each moves with its triangle: same weights of the corners, same side. Where the triangle has not moved, position and
//   normal keep their bits, so that what depends on the scene alone says the same of both. Samples without a triangle
//   stay where they are. Triangles are recognised by their corners' indices, which an evaluated scene keeps over time,
//   while triangles without area come and go; those that have gone take their samples along.
//
// Samples and both sets of triangles share their originWorld. Points that something hides are among them: that needs rays.
CarriedSamples carry(const ViewSamples& before, const LocalTriangles& trianglesBefore,
                     const LocalTriangles& trianglesNow, const View& viewNow);

// Those with `isKept` >= 0.5.
CarriedSamples keepOnly(const CarriedSamples& all, std::span<const float> isKept);

// Both, one list after the other; they share size and originWorld. Weights and marks are left out.
ViewSamples joined(const ViewSamples& first, const ViewSamples& second);

} // namespace lixel
