// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <string>
#include <vector>

namespace lixel {

// dot(normal, p) + offset = 0; positive on the side the normal points to.
struct Plane
{
    Vec3d normal{0, 1, 0};
    double offset = 0;

    double signedDistance(Vec3d p) const { return dot(normal, p) + offset; }
};

inline Plane planeThrough(Vec3d point, Vec3d normal) { return {normal, -dot(normal, point)}; }

// A plane of interest: one that the picture's receivers mostly lie in, named by the scene or the view file.
struct NamedPlane
{
    std::string name;
    Vec3d pointWorld;
    Vec3d normalWorld{0, 1, 0};
    std::vector<Vec3d> polygonWorld; // empty: the whole plane
};

} // namespace lixel
