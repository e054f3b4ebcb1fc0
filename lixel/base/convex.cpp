// SPDX-License-Identifier: MIT
#include "lixel/base/convex.h"

#include "lixel/base/rectangle.h"

#include <algorithm>

namespace lixel {
namespace {

constexpr std::size_t kMostCutPoints = 4 * 40; // two crossings and two corners on the plane for each face

// The polygon through points of one plane, counter-clockwise seen against `normal`.
ConvexBody::Face faceThrough(const FixedVector<Vec3d, kMostCutPoints>& points, Vec3d normal)
{
    const Vec3d u = anyPerpendicular(normal), v = cross(normal, u);
    const Vec3d origin = points[0];
    FixedVector<Vec2d, kMostCutPoints> flat;
    for (const Vec3d& p : points) flat.push_back({dot(u, p - origin), dot(v, p - origin)});
    FixedVector<Vec2d, kMostCutPoints + 1> hull;
    for (std::size_t i = 0; i < flat.size() + 1; ++i) hull.push_back({});
    const std::size_t corners = convexHull({flat.data(), flat.size()}, {hull.data(), hull.size()});
    ConvexBody::Face face;
    for (std::size_t i = 0; i < corners && i < face.capacity(); ++i)
        face.push_back(origin + hull[i].x * u + hull[i].y * v);
    return face;
}

} // namespace

ConvexBody bodyOf(const Box& box)
{
    ConvexBody body;
    if (box.isEmpty()) return body;
    const auto c = box.corners();
    // Corner i has x, y, z at their maxima where bits 0, 1, 2 of i are set.
    constexpr std::size_t kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& corners : kFaces) {
        ConvexBody::Face face;
        for (const std::size_t corner : corners) face.push_back(c[corner]);
        body.faces.push_back(face);
    }
    return body;
}

void clip(ConvexBody& body, const Plane& keep)
{
    const auto isOutside = [&](Vec3d p) { return keep.signedDistance(p) < 0; };
    const auto anyOutside = [&](const ConvexBody::Face& face) {
        return std::any_of(face.begin(), face.end(), isOutside);
    };
    if (std::none_of(body.faces.begin(), body.faces.end(), anyOutside)) return;

    ConvexBody out;
    FixedVector<Vec3d, kMostCutPoints> cut;
    for (const auto& face : body.faces) {
        ConvexBody::Face kept;
        for (std::size_t i = 0; i < face.size(); ++i) {
            const Vec3d a = face[i], b = face[(i + 1) % face.size()];
            const double da = keep.signedDistance(a), db = keep.signedDistance(b);
            if (da >= 0) kept.push_back(a);
            if (da >= 0 && da <= 0) cut.push_back(a);
            if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
                // From the inner point on, so that both faces of an edge find the same crossing.
                const Vec3d crossing = da > 0 ? a + (da / (da - db)) * (b - a) : b + (db / (db - da)) * (a - b);
                kept.push_back(crossing);
                cut.push_back(crossing);
            }
        }
        if (kept.size() >= 3) out.faces.push_back(kept);
    }
    if (!out.isEmpty() && cut.size() >= 3) {
        const ConvexBody::Face face = faceThrough(cut, -keep.normal);
        if (face.size() >= 3) out.faces.push_back(face);
    }
    body = out;
}

FixedVector<Plane, 6> clipPlanes(const Mat4d& clipFromSource)
{
    FixedVector<Plane, 6> planes;
    const Vec4d w = clipFromSource.row(3);
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            const Vec4d p = w + sign * clipFromSource.row(axis);
            const double size = length(xyz(p));
            // A normal that is rounding noise against the rows it came from has no plane: z <= w of an infinite view.
            const double terms = length(xyz(w)) + length(xyz(clipFromSource.row(axis)));
            if (size > 1e-13 * terms) planes.push_back({(1 / size) * xyz(p), p.w / size});
        }
    return planes;
}

} // namespace lixel
