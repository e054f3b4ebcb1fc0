// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/mat4.h"

#include <optional>

// How a region's fit takes points to the light's NDC: by a 4x4 matrix and division by w, or onto a paraboloid.
namespace lixel {

// A paraboloid of light rays (lixel/shared/paraboloid.h), of which the NDC square is a part. The matrix that goes with it takes points
// to the light's own axes: rows x, y and w are unit vectors, row z is (0, 0, 0, 1).
struct Paraboloid
{
    Vec2d centre, halfSize{1, 1}; // of that part, on the paraboloid; the half sphere is the disc of radius 1
    double near = 0,
           far = 1; // distances from the light with NDC depth -1 and +1; in between it is linear in 1 / distance
    friend bool operator==(const Paraboloid&, const Paraboloid&) = default;
};

// Where a unit ray in the light's axes (z along the map's axis) lies on the paraboloid, and back. Needs a ray that is not (0, 0, -1).
Vec2d onParaboloid(Vec3d ray);
Vec3d paraboloidRay(Vec2d place);

struct LightProjection
{
    Mat4d lightClipFromLocal;
    std::optional<Paraboloid> paraboloid;

    LightProjection(const Mat4d& matrix, const std::optional<Paraboloid>& onto = {})
        : lightClipFromLocal(matrix), paraboloid(onto)
    {
    }

    // NDC of a point, depth in [-1, +1] growing away from the light. Nothing where no ray of the map goes through it.
    std::optional<Vec3d> ndcAt(Vec3d pointLocal) const;

    // How NDC changes along a vector from there. Needs ndcAt().
    Vec3d ndcAlong(Vec3d pointLocal, Vec3d tangent) const;
};

} // namespace lixel
