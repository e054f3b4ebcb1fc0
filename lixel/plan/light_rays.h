// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/fixed_vector.h"
#include "lixel/base/light.h"
#include "lixel/plan/fit/light_frame.h"

#include <optional>
#include <span>
#include <vector>

// Sets of light rays, and which of them no map serves yet ("C^fallback", H. Chong, S. Gortler. A Lixel for every Pixel. 2004,
// section 3).
namespace lixel {

// Light rays as homogeneous vectors. From a point: the ray's direction. Parallel light: (s, t, 1), its place across the light. A
// half-space whose border holds the light is a linear function of such vectors, for either.
class RaySpace
{
public:
    RaySpace(const Light& light, Vec3d originWorld);

    Vec3d through(Vec3d pointLocal) const;
    Vec3d at(const LightFrame& frame, Vec2d onPlane) const; // frames of lightFrame()
    Vec3d insideOf(const Plane& throughLightLocal) const;   // dot(insideOf(plane), ray) >= 0 where the ray is inside
    bool holdsLight(const Plane& planeLocal, double sceneSize) const;

    // Some point of the ray in homogeneous coordinates, Local; for rays from a point its direction (w = 0), which has the same
    // x, y and w in any light image but for a factor.
    Vec4d imageOf(Vec3d ray) const;

    // A fit's image as a frame, in which areas and right angles are those of lixels: rows x and y are unit vectors.
    LightFrame frameOf(const Fit& fit) const;

private:
    bool isParallel_;
    Vec3d lightLocal_, right_, up_, back_;
};

// What of a polygon is inside a half-space; empty where nothing is. All of it where that would have too many corners.
RayPolygon clipped(const RayPolygon& polygon, Vec3d inside);

// All rays through some points: one polygon around them, or, where they do not fit half a sphere, the whole sphere in eight. Returns the
// points as frameAround() has them, its corners in the input's scratch; nothing where it has not.
std::optional<FramedBody> raysThrough(const FitInput& input, const RaySpace& space, std::span<const Vec3d> pointsLocal,
                                      std::vector<RayPolygon>& rays);

// Takes away the rays inside all of some half-spaces. What is left is cut into convex pieces; pieces that are nothing but rounding go.
// A set that would be cut into more than a few hundred is left as it was.
void subtract(std::vector<RayPolygon>& rays, std::span<const Vec3d> insides, std::vector<RayPolygon>& room);

// The fit with its square drawn in to what of it some rays need: the rectangle of least area around them, with room for what floats may move
// `pointsLocal` by, which it holds. Nothing where the rays miss its image. Fits that keep to the world's grid, or in whose image some
// ray has no place, stay as they are.
std::optional<Fit> croppedTo(const Fit& fit, const RaySpace& space, std::span<const RayPolygon> rays,
                             std::span<const Vec3d> pointsLocal, FitScratch::OnPlane& scratch);

} // namespace lixel
