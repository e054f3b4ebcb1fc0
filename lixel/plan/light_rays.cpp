// SPDX-License-Identifier: MIT
#include "lixel/plan/light_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lixel {
namespace {

// A map has this much room around its rays, of half the fit it was cut from.
constexpr double kRoom = 1e-6;

// Of the directions of rays, and of the sums that their images are: what is thinner than this, of angles, is rounding. Not much
// more is, since a scene a million of its radii away is such a part of a radian itself.
constexpr double kDoubleRounding = 16 * 0x1p-53;

// Corners of an image nearer to each other than this part of it are one.
constexpr double kOneCorner = 1e-9;

// So many convex pieces are worth their time.
constexpr std::size_t kMostPieces = 256;

// A light within this part of the scene's size of a plane lies in it, but for rounding.
constexpr double kInPlane = 1e-9;

// Clips to where dot(inside, ray) >= least |inside| |ray|; a polygon that would have too many corners stays whole.
RayPolygon clippedBeyond(const RayPolygon& polygon, Vec3d inside, double least)
{
    RayPolygon out;
    if (polygon.empty()) return out;
    const double size = length(inside);
    const auto excess = [&](Vec3d ray) { return dot(inside, ray) - least * size * length(ray); };
    Vec3d before = polygon.back();
    double atBefore = excess(before);
    for (const Vec3d& ray : polygon) {
        const double at = excess(ray);
        if ((at >= 0) != (atBefore >= 0)) {
            if (out.size() == kMostRayCorners) return polygon;
            const double share = atBefore / (atBefore - at);
            out.push_back((1 - share) * before + share * ray);
        }
        if (at >= 0) {
            if (out.size() == kMostRayCorners) return polygon;
            out.push_back(ray);
        }
        before = ray, atBefore = at;
    }
    if (out.size() < 3) out.clear();
    return out;
}

// The hull of a body's image. Corners that are one but for rounding are: how many there are must not hang on it.
std::span<const NumberedPoint> cornersOf(const FramedBody& body, FitScratch::OnPlane& scratch)
{
    scratch.numbered.clear();
    Vec2d most;
    for (std::size_t i = 0; i < body.corners.size(); ++i) {
        const Vec2d p = onLightPlane(body.frame, body.corners[i]);
        most = {std::max(most.x, std::abs(p.x)), std::max(most.y, std::abs(p.y))};
        scratch.numbered.push_back({p, std::uint32_t(i)});
    }
    std::vector<NumberedPoint>& hull = scratch.numberedHull;
    hull.resize(scratch.numbered.size() + 1);
    hull.resize(convexHull(scratch.numbered, hull));
    const double least = kOneCorner * length(most);
    const auto isOne = [least](const NumberedPoint& a, const NumberedPoint& b) { return length(b.p - a.p) <= least; };
    hull.erase(std::unique(hull.begin(), hull.end(), isOne), hull.end());
    return hull;
}

bool isAll(const RayPolygon& polygon, Vec3d inside)
{
    return std::all_of(polygon.begin(), polygon.end(), [&](Vec3d ray) { return dot(inside, ray) >= 0; });
}

} // namespace

RaySpace::RaySpace(const Light& light, Vec3d originWorld)
    : isParallel_(light.kind == LightKind::Directional),
      lightLocal_(light.positionWorld - originWorld),
      right_(anyPerpendicular(light.directionWorld)),
      up_(cross(right_, light.directionWorld)),
      back_(-light.directionWorld)
{
}

Vec3d RaySpace::through(Vec3d pointLocal) const
{
    if (isParallel_) return {dot(right_, pointLocal), dot(up_, pointLocal), 1};
    return pointLocal - lightLocal_;
}

Vec3d RaySpace::insideOf(const Plane& throughLightLocal) const
{
    const Vec3d n = throughLightLocal.normal;
    if (isParallel_) return {dot(right_, n), dot(up_, n), throughLightLocal.offset};
    return n;
}

Vec3d RaySpace::at(const LightFrame& frame, Vec2d onPlane) const
{
    // Rows x, y and w of such a frame are unit vectors at right angles.
    const Mat4d& m = frame.framedFromLocal;
    const Vec3d across = onPlane.x * xyz(m.row(0)) + onPlane.y * xyz(m.row(1));
    return isParallel_ ? through(across) : across + xyz(m.row(3));
}

bool RaySpace::holdsLight(const Plane& planeLocal, double sceneSize) const
{
    if (isParallel_) return std::abs(dot(planeLocal.normal, back_)) <= kInPlane * length(planeLocal.normal);
    // What is taken for a plane through the light is off by its distance from it, wherever the scene is: no more than nothing there.
    return std::abs(planeLocal.signedDistance(lightLocal_)) <=
           (kInPlane * sceneSize + kDoubleRounding * length(lightLocal_)) * length(planeLocal.normal);
}

Vec4d RaySpace::imageOf(Vec3d ray) const
{
    if (!isParallel_) return direction(ray);
    const Vec3d across = ray.x * right_ + ray.y * up_;
    return {across.x, across.y, across.z, ray.z};
}

RayPolygon clipped(const RayPolygon& polygon, Vec3d inside) { return clippedBeyond(polygon, inside, 0); }

std::optional<FramedBody> raysThrough(const FitInput& input, const RaySpace& space, std::span<const Vec3d> pointsLocal,
                                      std::vector<RayPolygon>& rays)
{
    rays.clear();
    if (pointsLocal.empty()) return std::nullopt;
    const auto body = frameAround(input, pointsLocal);
    if (!body) {
        for (const double x : {1.0, -1.0})
            for (const double y : {1.0, -1.0})
                for (const double z : {1.0, -1.0}) rays.push_back({Vec3d{x, 0, 0}, Vec3d{0, y, 0}, Vec3d{0, 0, z}});
        return std::nullopt;
    }
    const std::span<const NumberedPoint> hull = cornersOf(*body, input.scratch.plane);
    RayPolygon polygon;
    if (hull.size() >= 3 && hull.size() <= kMostRayCorners / 2) { // leaves room for what clipping adds
        for (const NumberedPoint& corner : hull) polygon.push_back(space.through(body->corners[corner.number]));
    } else {
        const OrientedRectangle around = rectangleAround(*body, RectangleKind::LeastArea, input.scratch);
        const Vec2d a = around.halfSize.x * around.axis, b = around.halfSize.y * Vec2d{-around.axis.y, around.axis.x};
        for (const auto& [sa, sb] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
            polygon.push_back(space.at(body->frame, around.centre + sa * a + sb * b));
    }
    rays.push_back(polygon);
    return *body;
}

void subtract(std::vector<RayPolygon>& rays, std::span<const Vec3d> insides, std::vector<RayPolygon>& room)
{
    room.clear();
    for (const RayPolygon& whole : rays) {
        RayPolygon left = whole; // inside of all half-spaces so far
        for (const Vec3d& inside : insides) {
            if (left.empty()) break;
            if (isAll(left, inside)) continue;
            const RayPolygon outside = clippedBeyond(left, -1.0 * inside, kDoubleRounding);
            if (!outside.empty()) room.push_back(outside);
            left = clipped(left, inside);
        }
        if (room.size() > kMostPieces) return;
    }
    rays.swap(room);
}

LightFrame RaySpace::frameOf(const Fit& fit) const
{
    const Mat4d& clip = fit.lightClipFromLocal;
    LightFrame frame;
    frame.framedFromLocal = clip;
    frame.framedFromLocal.setRow(0, (1 / length(xyz(clip.row(0)))) * clip.row(0));
    frame.framedFromLocal.setRow(1, (1 / length(xyz(clip.row(1)))) * clip.row(1));
    frame.isPerspective = !isParallel_;
    if (!isParallel_) frame.apexLocal = lightLocal_;
    return frame;
}

std::optional<Fit> croppedTo(const Fit& fit, const RaySpace& space, std::span<const RayPolygon> rays,
                             std::span<const Vec3d> pointsLocal, FitScratch::OnPlane& scratch)
{
    if (fit.snapsToWorld || fit.pixels) return fit;
    const Mat4d& clip = fit.lightClipFromLocal;
    const Vec4d x = clip.row(0), y = clip.row(1), w = clip.row(3);
    // Rays of receivers on the border of what the fit holds are in its square but for rounding.
    const Vec4d wide = (1 + kUnroomed) * w;
    const auto inside = [&](Vec4d side) { return space.insideOf({xyz(side), side.w}); };
    const std::array<Vec3d, 4> sides{inside(wide + x), inside(wide - x), inside(wide + y), inside(wide - y)};
    LightFrame frame = space.frameOf(fit);
    // Of parallel rays too, w is not 1 where the fit is a warped one.
    if (!frame.isPerspective && !pointsLocal.empty()) {
        frame.leastW = std::numeric_limits<double>::max();
        for (const Vec3d& p : pointsLocal) frame.leastW = std::min(frame.leastW, dot(w, point(p)));
        if (!(frame.leastW > 0)) return fit;
    }
    scratch.points.clear();
    double rounding = 0; // of rays, in their image
    for (const RayPolygon& polygon : rays) {
        RayPolygon within = polygon;
        for (const Vec3d& side : sides) within = clippedBeyond(within, side, -kDoubleRounding);
        for (const Vec3d& ray : within) {
            const Vec4d q = frame.framedFromLocal * space.imageOf(ray);
            if (!(q.w > 0)) return fit;
            rounding = std::max(rounding, kDoubleRounding * length(ray) / q.w);
            scratch.points.push_back({q.x / q.w, q.y / q.w});
        }
    }
    if (scratch.points.empty()) return std::nullopt;
    scratch.hull.resize(scratch.points.size() + 1);
    const std::size_t corners = convexHull(scratch.points, scratch.hull);
    const double perX = 1 / length(xyz(x)), perY = 1 / length(xyz(y)), room = kRoom * std::max(perX, perY) + rounding;
    const double least = frame.isPerspective ? kLeastTangent / length(xyz(w)) : 0;
    OrientedRectangle r = minimumAreaRectangle({scratch.hull.data(), corners});
    r.halfSize = {std::max((1 + kRoom) * r.halfSize.x + room, least),
                  std::max((1 + kRoom) * r.halfSize.y + room, least)};
    r = resolved(r, {frame, pointsLocal, pointsLocal});
    if (!(r.area() < 4 * perX * perY)) return fit;
    const auto along = [&](Vec2d axis, double half) {
        const Mat4d& framed = frame.framedFromLocal;
        return (1 / half) * (axis.x * framed.row(0) + axis.y * framed.row(1) - dot(axis, r.centre) * w);
    };
    Fit out = fit;
    out.lightClipFromLocal.setRow(0, along(r.axis, r.halfSize.x));
    out.lightClipFromLocal.setRow(1, along({-r.axis.y, r.axis.x}, r.halfSize.y));
    return out;
}

} // namespace lixel
