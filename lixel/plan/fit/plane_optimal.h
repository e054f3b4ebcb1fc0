// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/light_frame.h"

#include <optional>

namespace lixel {

// Maps in which every pixel that sees a plane has a lixel of its own that samples the same point.
//
//   H. Chong, S. Gortler. A Lixel for every Pixel. Eurographics Symposium on Rendering 2004, section 2.

struct PlaneOptimalFit
{
    bool uncoveredIsLit = false; // no fallback: what the planes' maps do not hold is lit and counted as unserved
    bool isOfSamples = false;    // held are the rays of the view samples, in place of all that may be seen
    friend bool operator==(const PlaneOptimalFit&, const PlaneOptimalFit&) = default;
};

// The light plane whose coordinates are pixels: (x / w, y / w) of any point is the pixel at which the view sees the place where
// the point's light ray meets the plane. Depth is that of LightFrame.
//
// With the plane pi turned so that pi.L > 0, L = (light, 1) for a point and (direction, 0) for a direction, rows x, y and w are
// those of M_v S, S = (pi.L) I - L pi^T: the matrix that takes a point along its light ray into the plane, then the view.
// w > 0 where that place lies before the viewer; past the plane's vanishing line, where rays leave the plane upwards, pixels
// go on and w stays positive (the sign of Figure 5). The light may be on either side of the plane.
//
//   Refuses  LightInPlane: within 1e-7 rad of it, as seen from the scene; EyeInPlane: likewise
//   Differs  the paper fixes five points and solves two linear systems (equations 1, 7-10), which has the same rows x, y, w but for a
//            factor; its depth is not used
Expected<LightFrame, FitFailure> planeOptimalFrame(const View& view, const Light& light, Vec3d originWorld,
                                                   const Plane& planeLocal, double sceneSize);

// The least rectangle of whole pixels, x0 <= x < x1, that holds a body framed in pixels, and so all lixels of its map at one a
// pixel (A_l of section 2, "Less of the plane"). Nothing where it has more than `most` pixels a side.
std::optional<PixelRectangle> wholePixelsAround(const FramedBody& body, int most);

// The map of the region's plane (FitInput::plane): of those light rays that go through what is visible of the region and
// meet the plane within the picture. Others are the next region's.
//
//   Needs    a plane; with isOfSamples, view samples
//   Returns  a fit of any resolution, twisted as the region asks; with wantsWholePixels one whose NDC square is a rectangle of whole
//            pixels (Fit::pixels): with as many lixels, lixel and pixel centres are the same points of the plane.
//            Near and far are tight to casters and receivers. What lies nearer to the light than 1e-4 of the map's depth is left to the
//            next region (Fit::narrowedTo)
//   Refuses  LightInPlane, EyeInPlane, NothingInView, EmptyScene, NoViewSamples; PlaneFacesAway: eye and light are on different sides, so
//            that nothing seen of it faces the light; TooFewLixels: a rectangle of whole pixels with sides above 32768
FitResult fitPlaneOptimal(const FitInput& input, const PlaneOptimalFit& fit);

} // namespace lixel
