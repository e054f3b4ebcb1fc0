// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/box.h"
#include "lixel/base/fixed_vector.h"
#include "lixel/base/mat4.h"
#include "lixel/base/plane.h"

namespace lixel {

// A convex body as its faces: convex polygons, each counter-clockwise seen from outside. Empty where it has none. Room for
// a box cut by a view, a light's cone and a region's half-spaces.
struct ConvexBody
{
    using Face = FixedVector<Vec3d, 40>;
    FixedVector<Face, 40> faces;

    bool isEmpty() const { return faces.empty(); }
};

ConvexBody bodyOf(const Box& box);

// Cuts off what lies where signedDistance < 0. The cut closes with a face; the body may become empty.
void clip(ConvexBody& body, const Plane& keep);

// The half-spaces -w <= x, y, z <= w of a projective matrix, as planes of its source space with unit normals, inside
// positive; those that do not exist there (the far side of an infinite view) are left out.
FixedVector<Plane, 6> clipPlanes(const Mat4d& clipFromSource);

} // namespace lixel
