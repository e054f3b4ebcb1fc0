// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/psm.h"

#include "lixel/plan/fit/along_view.h"
#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/visible_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lixel {
namespace {

// Depths that span less of the farthest are one but for rounding.
constexpr double kLeastSpan = 1e-9;

// How far aside from its axis the light may see something in the virtual view's cube, as a tangent: 88.8 degrees, as for any
// perspective map. It is the same all along a ray, of whose points any may be the corner that was kept.
constexpr double kMostTangent = 50;

// Steps of moving the virtual camera back, against the farthest depth that is seen, each twice the last.
constexpr double kFirstStep = 1.0 / 16;
constexpr int kMostSteps = 16;

// The share of the view's own depth that a caster may come near to the virtual camera.
constexpr double kLeastClearance = 1e-3;

// Where the casters begin along the line of sight, those between the light and what is seen; `most` where none is nearer.
double nearestCasterDepth(const FitInput& input, const FramedBody& body, const ViewDepth& depth, double most)
{
    const OrientedRectangle rectangle = rectangleAround(body, RectangleKind::LeastArea, input.scratch);
    const double far = farthestDepth(body);
    const Vec4d function{depth.forward.x, depth.forward.y, depth.forward.z, depth.offset};
    return leastOverCasters(input, fitRectangle(body.frame, rectangle, far, far, input).lightClipFromLocal, function,
                            most);
}

// The view's perspective, its camera moved back by `shift`: Local to homogeneous coordinates that are in [-1, +1] for all that
// is seen. Moved back along the line of sight, where x and y vanish, the camera still has all of it in its picture.
Mat4d virtualClipFromLocal(const FitInput& input, const ViewDepth& depth, double shift, const DepthSpan& depths)
{
    const Mat4d clip = clipFromLocal(input.view, input.originWorld);
    const double perDepth = length(xyz(clip.row(3))); // rows x and y are against the view's own w
    const Vec4d w{depth.forward.x, depth.forward.y, depth.forward.z, depth.offset + shift};
    const double near = depths.nearest + shift, far = depths.farthest + shift;
    const Vec4d z = (1 / (far - near)) * ((far + near) * w - Vec4d{0, 0, 0, 2 * far * near});
    return Mat4d::fromRows((1 / perDepth) * clip.row(0), (1 / perDepth) * clip.row(1), z, w);
}

// How the light sees the cube of the virtual view.
struct CubeFrame
{
    Mat4d framedFromLocal; // rows vanish at the light; w is 1 at the cube's middle
    double
        perDistance; // of the light from the middle, 0 for one at infinity: x and y of 1 / perDistance are 45 degrees aside
};

// The same formula serves lights at infinity there, whose fourth coordinate is 0.
CubeFrame lookAtCube(const Mat4d& virtualClip, Vec4d lightLocal, Vec4d depthRow)
{
    const Vec4d l = virtualClip * lightLocal;
    const Vec3d toLight = l.w < 0 ? -xyz(l) : xyz(l);
    const double perDistance = length(xyz(l)) > 0 ? std::abs(l.w) / length(xyz(l)) : 0;
    const Vec3d axis = -normalized(toLight), right = anyPerpendicular(axis), up = cross(right, axis);
    const Vec4d cx = virtualClip.row(0), cy = virtualClip.row(1), cz = virtualClip.row(2), cw = virtualClip.row(3);
    const auto along = [&](Vec3d a) { return a.x * cx + a.y * cy + a.z * cz; };
    return {Mat4d::fromRows(along(right), along(up), depthRow, perDistance * along(axis) + cw), perDistance};
}

// The body as the light sees it in the virtual view; nothing where the light lies within or beside it there.
std::optional<FramedBody> seenByLight(const FitInput& input, const Mat4d& virtualClip, const FramedBody& body)
{
    const bool isParallel = input.light.kind == LightKind::Directional;
    const Vec4d lightLocal =
        isParallel ? direction(-input.light.directionWorld) : point(input.light.positionWorld - input.originWorld);
    const CubeFrame cube = lookAtCube(virtualClip, lightLocal, body.frame.framedFromLocal.row(2));
    FramedBody seen = body;
    seen.frame.framedFromLocal = cube.framedFromLocal;
    if (!isParallel) seen.frame.framedFromLocal.setRow(2, seen.frame.framedFromLocal.row(3));
    const bool isBefore = std::all_of(body.corners.begin(), body.corners.end(), [&](Vec3d p) {
        const Vec4d q = cube.framedFromLocal * point(p);
        const double most = kMostTangent * q.w, perDistance = cube.perDistance;
        return q.w > 0 && perDistance * perDistance * (q.x * q.x + q.y * q.y) < most * most;
    });
    if (!isBefore) return std::nullopt;
    return held(seen);
}

} // namespace

FitResult fitPsm(const FitInput& input, PsmShift shift)
{
    const auto body = visibleBody(input);
    if (!body) return Unexpected{body.error()};
    const ViewDepth depth = viewDepth(input.view, input.originWorld);
    const DepthSpan depths = seenDepths(input, depth, body->points);
    if (!depth.isPerspective || !(depths.farthest - depths.nearest > kLeastSpan * depths.farthest))
        return fitTightly(*body, RectangleKind::LeastArea, input);

    const double clearance = kLeastClearance * depths.farthest;
    double back = 0;
    if (shift == PsmShift::Casters) back = clearance - nearestCasterDepth(input, *body, depth, clearance);
    // A light within or beside the picture leaves it as the camera moves back.
    for (int i = 0; i < kMostSteps; ++i) {
        const auto seen = seenByLight(input, virtualClipFromLocal(input, depth, back, depths), *body);
        if (seen) return fitTightly(*seen, RectangleKind::LeastArea, input);
        back = 2 * back + kFirstStep * depths.farthest;
    }
    return fitTightly(*body, RectangleKind::LeastArea, input);
}

} // namespace lixel
