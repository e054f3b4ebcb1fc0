// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view.h"
#include "lixel/plan/light_image.h"

#include <optional>

namespace lixel {

// The one Jacobian, light image against picture, at a surface point: how lixels lie on pixels there. Bias, predicted error,
// budgets and taps all come from it.
//
//   H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007, appendix; D. B. Lloyd. Logarithmic Perspective Shadow Maps.
//   PhD thesis, 2007 (m, the largest singular value).
struct Footprint
{
    double lixelFromPixel[2][2] = {{1, 0}, {0, 1}}; // d lixel / d pixel
    Vec2d depthPerLixel;                            // of the receiver's plane, NDC depth a lixel
    double pixelsPerLixel = 1; // Lloyd's m: the longest axis of a lixel, in pixels (infinite: edge-on)
    double lixelsPerPixel = 1; // by area
};

// Of the plane through the point with this normal. Nothing where the point is behind the eye or the light or outside the image's
// rectangle, or where its plane is edge-on to the view.
std::optional<Footprint> footprint(const View& view, Vec3d originWorld, const LightImage& image, Vec3d pointLocal,
                                   Vec3d normal);

} // namespace lixel
