// SPDX-License-Identifier: MIT
#include "lixel/plan/region_table.h"

#include "lixel/plan/clip_convention.h"

namespace lixel {
namespace {

// What lookups of points on a plane go by (ShadowRegion::plane): row z is a combination of rows x, y, w and the plane's own.
void addPlane(const Plane& plane, const PlannedRegion& region, shared::ShadowRegion& row)
{
    const Mat4d clip = toHost(region.lightClipFromLocal, kExecutorConvention);
    const Vec4d own{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
    const auto fromRows = inverse(Mat4d::fromRows(clip.row(0), clip.row(1), own, clip.row(3)));
    if (!fromRows) return;
    const Vec4d c = transpose(*fromRows) * clip.row(2);
    const double perX = 2.0 / region.rectangle.width(), perY = 2.0 / region.rectangle.height();
    row.plane = {float(own.x), float(own.y), float(own.z), float(own.w)};
    row.planeDepth = {float(c.w), float(perX * c.x), float(perY * c.y), float(c.z)};
}

// ShadowRegion::projection z (lookup/even_depth.h). Depths are 0 at the far side, so at infinity they are below.
constexpr double kMostBend = 1 - 0x1p-20;
float bendOf(double depthAtInfinity)
{
    return depthAtInfinity < 0 ? float(std::min(1 / (1 - depthAtInfinity), kMostBend)) : 0;
}

// Depth N (F / r - 1) / (F - N), reversed: NF / (F - N) over the distance, which row z has, less N / (F - N). Places on the paraboloid
// take the place of NDC.
void putOnParaboloid(const Paraboloid& p, const LixelRectangle& r, Mat4d& clip, shared::ShadowRegion& row)
{
    clip.setRow(2, {0, 0, 0, p.near * p.far / (p.far - p.near)});
    const double perX = 0.5 * r.width() / p.halfSize.x, perY = 0.5 * r.height() / p.halfSize.y;
    row.lixelFromNdc = {float(perX), float(perY), float(0.5 * (r.x0 + r.x1) - perX * p.centre.x),
                        float(0.5 * (r.y0 + r.y1) - perY * p.centre.y)};
    row.projection = {shared::LX_PROJECTION_PARABOLOID, float(p.near / (p.far - p.near)),
                      bendOf(-p.near / (p.far - p.near)), 0};
}

// By what depth comes to at infinity along the ray through the map's centre; nothing where rays are parallel.
std::optional<double> depthAtInfinity(const Mat4d& clip)
{
    // Infinite is what has no w: of clip places (0, 0, D, 1) the one for which row 3 of the inverse is 0.
    const auto localFromClip = inverse(clip);
    if (!localFromClip || localFromClip->row(3).z == 0) return std::nullopt;
    return -localFromClip->row(3).w / localFromClip->row(3).z;
}

} // namespace

shared::ShadowRegion tableRow(const PlannedRegion& region)
{
    const LixelRectangle& r = region.rectangle;
    shared::ShadowRegion row;
    Mat4d clip = toHost(region.lightClipFromLocal, kExecutorConvention);
    row.lixelFromNdc = {0.5f * float(r.width()), 0.5f * float(r.height()), float(r.x0) + 0.5f * float(r.width()),
                        float(r.y0) + 0.5f * float(r.height())};
    if (region.paraboloid) putOnParaboloid(*region.paraboloid, r, clip, row);
    else if (const auto depth = depthAtInfinity(clip)) row.projection.z = bendOf(*depth);
    Mat4d low;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) low.m[i][j] = clip.m[i][j] - double(float(clip.m[i][j]));
    row.lightClipFromLocal = toShared(clip);
    row.lightClipLow = toShared(low);
    row.rectangle = {float(r.x0), float(r.y0), float(r.x1), float(r.y1)};
    const Vec2f guard = toFloat(region.guard);
    row.serves = {row.rectangle.x + guard.x, row.rectangle.y + guard.y, row.rectangle.z - guard.x,
                  row.rectangle.w - guard.y};
    row.place = {float(r.layer), 0, 0, region.isInDouble ? 1.0f : 0.0f};
    if (region.pixelPlaneLocal) addPlane(*region.pixelPlaneLocal, region, row);
    return row;
}

} // namespace lixel
