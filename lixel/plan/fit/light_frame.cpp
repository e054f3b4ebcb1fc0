// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/light_frame.h"

#include "lixel/plan/fit/visible_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace lixel {
namespace {

// Perspective maps start no nearer than this part of their far depth: reversed float depth keeps its relative precision down
// to here while a triangle that spans the whole range is interpolated. Casters still nearer are clamped, which shadows alike.
constexpr double kLeastNearPerFar = 1e-4;

// A warp's horizon must stay clear of what is held: w changes by this factor at most.
constexpr double kLeastRelativeW = 1e-6;

// Of the terms that it is the sum of, so much must be left of w: less is sixteen roundings of the floats that executors have.
constexpr double kLeastOfTermsOfW = 16 * 0x1p-24;

// A rectangle has this size at least, against its distance from the light plane's origin: a map of one line or point is still a map.
constexpr double kLeastRelativeHalfSize = 1e-9;

// Floats round by this part of their terms, 2^-24, wherever they are made: a rectangle is not smaller than some two thousand times
// that. Nor are its depths.
constexpr double kLeastPerRounding = 2e3 * 0x1p-24;

// What all roundings on the way to a lixel come to: of the position, of the map's row, of their products, and of three sums.
constexpr double kRoomPerRounding = 6 * 0x1p-24;

// Of a scene that is one point, at the very origin.
constexpr double kLeastRoom = 1e-12;

// Nearer to the light than this part of the farthest distance is next to it.
constexpr double kNextToLight = 1.0 / 64;

// Directions nearer the cone's border than this count as inside: above rounding, far below a lixel.
constexpr double kConeSlack = 1e-14;

// A direction outside by more than this is lost, rather than rounded.
constexpr double kLostFromCone = 1e-7;

// A frame whose light sees points farther aside than this tangent is not used to tell corners.
constexpr double kMostBeside = 30;

// So far, against the whole, corners may be left out beside a line between others: below a rectangle's least half size, which
// every rectangle has as room.
constexpr double kNoLoss = 1e-10;

// Casters beside a map by less than this part of what their distance is made of only touch it; they count as in it, so that
// rounding does not decide.
constexpr double kTouching = 1e-9;

// A little room so that receivers on the very border stay inside after rounding to float.
constexpr double kBorder = 1 + 1e-6;

// The linear function of a homogeneous row at a box: its middle value and how far it goes to both sides.
struct Interval
{
    double middle = 0, reach = 0;
};

Vec4d absolute(Vec4d row) { return {std::abs(row.x), std::abs(row.y), std::abs(row.z), std::abs(row.w)}; }

Interval over(Vec4d row, Vec3d centre, Vec3d half) { return {dot(row, point(centre)), dot(xyz(absolute(row)), half)}; }

// Whether a box is outside a half-space by more than rounding.
bool isBeyond(Vec4d side, Vec3d centre, Vec3d half)
{
    const Interval value = over(side, centre, half);
    const Vec4d size = absolute(side);
    const double terms = dot(xyz(size), {std::abs(centre.x), std::abs(centre.y), std::abs(centre.z)}) + size.w;
    return value.middle + value.reach < -kTouching * terms;
}

// Rows whose values are those of w times the place from a rectangle's middle, along its sides.
struct SideRows
{
    Vec4d u, v;
};

SideRows sideRows(const LightFrame& frame, const OrientedRectangle& rectangle)
{
    const Vec4d x = frame.framedFromLocal.row(0), y = frame.framedFromLocal.row(1), w = frame.framedFromLocal.row(3);
    const auto along = [&](Vec2d axis) { return axis.x * x + axis.y * y - dot(axis, rectangle.centre) * w; };
    return {along(rectangle.axis), along({-rectangle.axis.y, rectangle.axis.x})};
}

// How far rounding of one part may move points within a rectangle, as if all that is worst came together: the farthest of them from
// the origin, and the least w.
Vec2d mostRounding(const SideRows& rows, Vec4d w, const OrientedRectangle& rectangle, double reach, double leastW)
{
    const auto size = [reach](Vec4d r) {
        return (std::abs(r.x) + std::abs(r.y) + std::abs(r.z)) * reach + std::abs(r.w);
    };
    return {(size(rows.u) + rectangle.halfSize.x * size(w)) / leastW,
            (size(rows.v) + rectangle.halfSize.y * size(w)) / leastW};
}

// Whether so little that a rectangle needs no room for it.
bool needsNoRoom(Vec2d rounding, const OrientedRectangle& rectangle)
{
    return kRoomPerRounding * rounding.x < kUnroomed * rectangle.halfSize.x &&
           kRoomPerRounding * rounding.y < kUnroomed * rectangle.halfSize.y;
}

// The w of lights at a point that tells, without asking for distances from the light, that no point is next to it.
double leastWBeside(const LightFrame& frame, double reach)
{
    return kNextToLight * (length(frame.apexLocal) + reach) * length(xyz(frame.framedFromLocal.row(3)));
}

// Whether the box around a body's points tells already that its rectangle needs no room.
bool needsNoRoom(const FramedBody& body, const OrientedRectangle& rectangle)
{
    if (body.bounds.isEmpty()) return false;
    const Vec3d centre = body.bounds.centre(), half = 0.5 * (body.bounds.max - body.bounds.min);
    const Vec4d w = body.frame.framedFromLocal.row(3);
    const Interval values = over(w, centre, half);
    const double reach = length(centre) + length(half),
                 leastW = body.frame.isPerspective ? values.middle - values.reach : body.frame.leastW;
    if (body.frame.isPerspective && !(leastW > leastWBeside(body.frame, reach))) return false;
    return needsNoRoom(mostRounding(sideRows(body.frame, rectangle), w, rectangle, reach, leastW), rectangle);
}

// How far rounding of one part moves points within a rectangle, along its sides: the terms of their coordinates, counted from its
// middle. Points next to the light, which no map resolves, count as if they were not quite as near.
Vec2d roundingIn(const LightFrame& frame, const OrientedRectangle& rectangle, std::span<const Vec3d> points)
{
    const Vec4d w = frame.framedFromLocal.row(3);
    const SideRows rows = sideRows(frame, rectangle);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double leastW = frame.isPerspective ? kInfinity : frame.leastW, farthest = 0;
    if (frame.isPerspective)
        for (const Vec3d& p : points) {
            farthest = std::max(farthest, dot(p, p));
            leastW = std::min(leastW, dot(w, point(p)));
        }
    else
        for (const Vec3d& p : points) farthest = std::max(farthest, dot(p, p));
    const double reach = std::sqrt(farthest);

    // Most bodies keep away from the light by far: w, which is 0 there, tells so without their distances.
    double leastAway = kInfinity, next = 0; // squares
    if (frame.isPerspective && leastW < leastWBeside(frame, reach)) {
        double mostAway = 0;
        for (const Vec3d& p : points) {
            const double away = squaredDistance(p, frame.apexLocal);
            leastAway = std::min(leastAway, away);
            mostAway = std::max(mostAway, away);
        }
        next = kNextToLight * kNextToLight * mostAway;
    }
    const bool isNext = leastAway < next;

    // Mostly that is little enough.
    const Vec2d bound = mostRounding(rows, w, rectangle, reach, leastW);
    if (!isNext && needsNoRoom(bound, rectangle)) return bound;
    Vec2d most;
    for (Vec3d p : points) {
        if (const double away = squaredDistance(p, frame.apexLocal); isNext && away < next)
            p = frame.apexLocal + std::sqrt(next / away) * (p - frame.apexLocal);
        const auto terms = [&p](Vec4d r) {
            return std::abs(r.x * p.x) + std::abs(r.y * p.y) + std::abs(r.z * p.z) + std::abs(r.w);
        };
        const double perW = 1 / dot(w, point(p)), termsOfW = terms(w);
        most.x = std::max(most.x, perW * (terms(rows.u) + std::abs(perW * dot(rows.u, point(p))) * termsOfW));
        most.y = std::max(most.y, perW * (terms(rows.v) + std::abs(perW * dot(rows.v, point(p))) * termsOfW));
    }
    return most;
}

// Half a side with room for rounding: nothing where receivers keep within kUnroomed of their reach anyway.
double withRoom(double half, double rounding)
{
    return std::max({half, kLeastPerRounding * rounding, (1 - kUnroomed) * half + kRoomPerRounding * rounding});
}

// The terms that depths, counted from the far side, are made of.
double termsOfDepth(const LightFrame& frame, double farDepth, const Box& sceneLocal)
{
    const Vec4d depth = frame.framedFromLocal.row(2);
    const auto farthest = [](double low, double high) { return std::max(std::abs(low), std::abs(high)); };
    return std::abs(depth.x) * farthest(sceneLocal.min.x, sceneLocal.max.x) +
           std::abs(depth.y) * farthest(sceneLocal.min.y, sceneLocal.max.y) +
           std::abs(depth.z) * farthest(sceneLocal.min.z, sceneLocal.max.z) + std::abs(farDepth - depth.w);
}

// The nearest depth of all boxes that reach into the pyramid (prism) of the rectangle; one that only touches is included.
double nearestCaster(const LightFrame& frame, const OrientedRectangle& rectangle, const FitInput& input)
{
    const Vec4d x = frame.framedFromLocal.row(0), y = frame.framedFromLocal.row(1), w = frame.framedFromLocal.row(3),
                depth = frame.framedFromLocal.row(2);
    const auto sides = [&](Vec2d axis, double half) {
        const Vec4d along = axis.x * x + axis.y * y - dot(axis, rectangle.centre) * w;
        return std::array<Vec4d, 2>{half * w + along, half * w - along};
    };
    const std::array<Vec4d, 2> first = sides(rectangle.axis, rectangle.halfSize.x);
    const std::array<Vec4d, 2> second = sides({-rectangle.axis.y, rectangle.axis.x}, rectangle.halfSize.y);
    const std::array<Vec4d, 4> inside{first[0], first[1], second[0], second[1]};

    double nearest = std::numeric_limits<double>::infinity();
    for (const Box& boxWorld : input.casterBoxesWorld) {
        if (boxWorld.isEmpty()) continue;
        const Vec3d centre = boxWorld.centre() - input.originWorld, half = 0.5 * (boxWorld.max - boxWorld.min);
        const Interval depths = over(depth, centre, half);
        if (depths.middle - depths.reach >= nearest) continue;
        const bool isBeside =
            std::any_of(inside.begin(), inside.end(), [&](Vec4d side) { return isBeyond(side, centre, half); });
        if (!isBeside) nearest = depths.middle - depths.reach;
    }
    return nearest;
}

// Of points with these places on the light plane the corners of their image.
void keepHull(std::span<const Vec3d> points, FitScratch& scratch)
{
    auto& [onPlane, hull, numbered, numberedHull] = scratch.plane;
    numbered.clear();
    HullSieve(onPlane, kNoLoss).forEachOuter([&](std::size_t i) { // what a cone cuts lies in line
        numbered.push_back({onPlane[i], std::uint32_t(i)});
    });
    numberedHull.resize(numbered.size() + 1);
    const std::size_t corners = convexHull(numbered, numberedHull);
    scratch.corners.clear();
    for (std::size_t i = 0; i < corners; ++i) scratch.corners.push_back(points[numberedHull[i].number]);
}

// The same for any points; all, where some are beside the frame's light or behind it: the image of a point beside it lies far
// away, and against that everything else is small.
void keepCorners(const LightFrame& frame, std::span<const Vec3d> points, FitScratch& scratch)
{
    std::vector<Vec2d>& onPlane = scratch.plane.points;
    onPlane.resize(points.size());
    const Vec4d x = frame.framedFromLocal.row(0), y = frame.framedFromLocal.row(1), w = frame.framedFromLocal.row(3);
    bool areBefore = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec4d p = point(points[i]);
        const double ofX = dot(x, p), ofY = dot(y, p), ofW = dot(w, p), perW = 1 / ofW;
        onPlane[i] = {perW * ofX, perW * ofY};
        areBefore &= !frame.isPerspective || std::max(std::abs(ofX), std::abs(ofY)) < kMostBeside * ofW;
    }
    if (!areBefore) {
        scratch.corners.assign(points.begin(), points.end());
        return;
    }
    keepHull(points, scratch);
}

// Sides on both axes, and depth from the near side to the far, with room for its rounding as sides have.
Fit fitSides(const LightFrame& frame, const OrientedRectangle& rectangle, double nearDepth, double farDepth,
             const FitInput& input)
{
    double near = std::min(nearDepth, farDepth);
    if (frame.isPerspective) near = std::max(near, kLeastNearPerFar * farDepth);
    const double span = farDepth - near, terms = termsOfDepth(frame, farDepth, input.sceneLocal);
    const double roomOfDepth = std::max({1e-6 * span, 1e-9 * (std::abs(farDepth) + std::abs(near)),
                                         kLeastPerRounding * terms - span, kRoomPerRounding * terms, kLeastRoom});
    near -= frame.isPerspective ? std::min(roomOfDepth, 0.5 * near) : roomOfDepth;
    const double far = farDepth + roomOfDepth;

    const Vec4d x = frame.framedFromLocal.row(0), y = frame.framedFromLocal.row(1),
                depth = frame.framedFromLocal.row(2), w = frame.framedFromLocal.row(3);
    const Vec2d a = rectangle.axis, b{-a.y, a.x};
    const auto along = [&](Vec2d axis, double half) {
        return (1 / half) * (axis.x * x + axis.y * y - dot(axis, rectangle.centre) * w);
    };
    // What is left to the far side, 1 at the near side and 0 at the far, times w: linear in depth where w does not change along
    // rays, and linear in 1 / depth where it is the depth. A warp of parallel light changes w across the map; the least
    // of it keeps all that must be held within the near side.
    const double nearest = frame.isPerspective ? near : frame.leastW;
    const Vec4d left = (nearest / (far - near)) * (Vec4d{0, 0, 0, far} - depth);
    return {Mat4d::fromRows(along(a, rectangle.halfSize.x), along(b, rectangle.halfSize.y), w - 2.0 * left, w)};
}

std::span<const Vec2d> cornersOnPlane(const FramedBody& body, FitScratch& scratch)
{
    scratch.plane.points.clear();
    for (const Vec3d& p : body.corners) scratch.plane.points.push_back(onLightPlane(body.frame, p));
    return scratch.plane.points;
}

} // namespace

LightFrame lightFrame(const Light& light, Vec3d originWorld, Vec3d axisLocal)
{
    const bool isPerspective = light.kind != LightKind::Directional;
    const Vec3d axis = isPerspective ? axisLocal : light.directionWorld;
    const Vec3d right = anyPerpendicular(axis), up = cross(right, axis);
    const Vec3d apex = isPerspective ? light.positionWorld - originWorld : Vec3d{};
    const auto row = [&apex](Vec3d a) { return Vec4d{a.x, a.y, a.z, -dot(a, apex)}; };
    return {Mat4d::fromRows(row(right), row(up), row(axis), isPerspective ? row(axis) : Vec4d{0, 0, 0, 1}),
            isPerspective, apex};
}

DirectionCone coneAround(std::span<const Vec3d> pointsLocal, Vec3d apexLocal, std::vector<Vec3d>& room)
{
    LX_ASSERT(!pointsLocal.empty());
    // Scattered order: neighbours in the list are neighbours in space, which would make the search below quadratic.
    std::size_t stride = std::size_t(0.618 * double(pointsLocal.size())) | 1;
    while (std::gcd(stride, pointsLocal.size()) != 1) stride += 2;
    stride %= pointsLocal.size();
    room.resize(pointsLocal.size());
    for (std::size_t i = 0, k = 0; i < room.size(); ++i) {
        room[i] = normalized(pointsLocal[k] - apexLocal);
        k += stride;
        if (k >= room.size()) k -= room.size();
    }
    const std::span<const Vec3d> towards = room;
    const auto isOutside = [](const DirectionCone& cone, Vec3d d) {
        return dot(cone.axis, d) < cone.cosHalfAngle - kConeSlack;
    };
    const auto through = [](Vec3d axis, Vec3d d) { return DirectionCone{axis, dot(axis, d)}; };
    const auto throughThree = [&](Vec3d a, Vec3d b, Vec3d c) {
        const Vec3d axis = normalized(cross(b - a, c - a));
        return through(dot(axis, a) < 0 ? -axis : axis, a);
    };

    // Welzl 1991, on the sphere: the narrowest cone changes only for a direction outside it, which is then on its border.
    // Directions that do not fit a half-space have no narrowest cone, and the search would find another one at nearly every
    // direction: it ends at the first cone that loses what came before.
    DirectionCone cone{towards[0], 1};
    bool isThere = true;
    for (std::size_t i = 1; i < towards.size() && isThere; ++i) {
        const Vec3d a = towards[i];
        if (!isOutside(cone, a)) continue;
        cone = {a, 1};
        for (std::size_t j = 0; j < i && isThere; ++j) {
            const Vec3d b = towards[j];
            if (!isOutside(cone, b)) continue;
            cone = through(normalized(a + b), a);
            for (std::size_t k = 0; k < j; ++k)
                if (isOutside(cone, towards[k])) cone = throughThree(a, b, towards[k]);
            isThere = std::all_of(towards.begin(), towards.begin() + std::ptrdiff_t(j),
                                  [&cone](Vec3d d) { return dot(cone.axis, d) > cone.cosHalfAngle - kLostFromCone; });
        }
    }
    // Whether it is the narrowest or not, the cosine says how wide the cone about this axis must be.
    for (const Vec3d& d : towards) cone.cosHalfAngle = std::min(cone.cosHalfAngle, dot(cone.axis, d));
    return cone;
}

std::optional<FramedBody> warped(const FramedBody& body, const PlaneWarp& warp)
{
    const Mat4d& from = body.frame.framedFromLocal;
    const auto along = [&](Vec3d row) { return row.x * from.row(0) + row.y * from.row(1) + row.z * from.row(3); };
    FramedBody out = body;
    const Vec4d newW = along(warp.w);
    out.frame.framedFromLocal.setRow(0, along(warp.x));
    out.frame.framedFromLocal.setRow(1, along(warp.y));
    out.frame.framedFromLocal.setRow(3, newW);
    if (body.frame.isPerspective) out.frame.framedFromLocal.setRow(2, newW);
    return held(out);
}

std::optional<FramedBody> framedIn(const LightFrame& frame, std::span<const Vec3d> points, FitScratch& scratch)
{
    const auto all = held({frame, points, points});
    if (points.empty() || !all) return std::nullopt;
    scratch.plane.points.clear();
    for (const Vec3d& p : points) scratch.plane.points.push_back(onLightPlane(frame, p));
    keepHull(points, scratch);
    FramedBody body = *all;
    body.corners = scratch.corners;
    return body;
}

std::optional<FramedBody> held(FramedBody body)
{
    const Vec4d w = body.frame.framedFromLocal.row(3), size = absolute(w);
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const Vec3d& p : body.corners) {
        const double value = dot(w, point(p));
        const double terms = dot(size, point({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
        if (!(value > kLeastOfTermsOfW * terms)) return std::nullopt;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    if (!(least > kLeastRelativeW * most)) return std::nullopt;
    body.frame.leastW = body.frame.isPerspective ? 1 : least;
    return body;
}

Expected<FramedBody, FitFailure> frameAround(const FitInput& input, std::span<const Vec3d> points)
{
    FitScratch& scratch = input.scratch;
    if (input.light.kind == LightKind::Directional) {
        const LightFrame frame = lightFrame(input.light, input.originWorld, input.light.directionWorld);
        keepCorners(frame, points, scratch);
        return FramedBody{frame, points, scratch.corners};
    }
    // Any frame with all points before the light has the same corners; most often one towards the middle of them has.
    const Vec3d lightLocal = input.light.positionWorld - input.originWorld;
    Box box;
    for (const Vec3d& p : points) box.include(p);
    keepCorners(lightFrame(input.light, input.originWorld, normalized(box.centre() - lightLocal)), points, scratch);
    const DirectionCone cone = coneAround(scratch.corners, lightLocal, scratch.directions);
    if (cone.cosHalfAngle < kLeastCosHalfAngle) return Unexpected{FitFailure::ExtentNotInHemisphere};
    return FramedBody{lightFrame(input.light, input.originWorld, cone.axis), points, scratch.corners, box};
}

Expected<FramedBody, FitFailure> visibleBody(const FitInput& input)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    if (input.cellLocal.empty() && input.visible) return *input.visible;
    findVisiblePoints(input, input.scratch.points);
    if (input.scratch.points.empty()) return Unexpected{FitFailure::NothingInView};
    return frameAround(input, input.scratch.points);
}

OrientedRectangle resolved(OrientedRectangle rectangle, const FramedBody& body)
{
    if (needsNoRoom(body, rectangle)) return rectangle;
    const Vec2d rounding = roundingIn(body.frame, rectangle, body.points);
    rectangle.halfSize = {withRoom(rectangle.halfSize.x, rounding.x), withRoom(rectangle.halfSize.y, rounding.y)};
    return rectangle;
}

OrientedRectangle rectangleAround(const FramedBody& body, RectangleKind kind, FitScratch& scratch)
{
    if (kind == RectangleKind::Upright) return rectangleAround(body, Vec2d{1, 0}, scratch);
    cornersOnPlane(body, scratch);
    std::vector<Vec2d>&onPlane = scratch.plane.points, &hull = scratch.plane.hull;
    hull.resize(onPlane.size() + 1);
    const std::size_t corners = convexHull(onPlane, hull);
    return resolved(minimumAreaRectangle({hull.data(), corners}), body);
}

OrientedRectangle rectangleAround(const FramedBody& body, Vec2d axis, FitScratch& scratch)
{
    return resolved(rectangleAlong(cornersOnPlane(body, scratch), axis), body);
}

double floatRounding(const FramedBody& body, const OrientedRectangle& rectangle)
{
    constexpr double kOfTerms = 0x1p-23; // the matrix's own half, and as much for products and sums
    const Vec4d x = body.frame.framedFromLocal.row(0), y = body.frame.framedFromLocal.row(1),
                w = body.frame.framedFromLocal.row(3);
    const auto along = [&](Vec2d axis, double half) {
        return (1 / half) * (axis.x * x + axis.y * y - dot(axis, rectangle.centre) * w);
    };
    const Vec4d u = along(rectangle.axis, rectangle.halfSize.x),
                v = along({-rectangle.axis.y, rectangle.axis.x}, rectangle.halfSize.y);
    double most = 0;
    for (const Vec3d& p : body.points) {
        const auto terms = [&p](Vec4d r) {
            return std::abs(r.x * p.x) + std::abs(r.y * p.y) + std::abs(r.z * p.z) + std::abs(r.w);
        };
        const double perW = 1 / dot(w, point(p));
        // Inside, u / w and v / w are between -1 and +1.
        most = std::max(most, perW * (std::max(terms(u), terms(v)) + terms(w)));
    }
    return kOfTerms * most;
}

double farthestDepth(const FramedBody& body)
{
    const Vec4d depth = body.frame.framedFromLocal.row(2);
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Vec3d& p : body.points) farthest = std::max(farthest, dot(depth, point(p)));
    return farthest;
}

Fit fitTightly(const FramedBody& body, RectangleKind kind, const FitInput& input)
{
    return fitRectangle(body.frame, rectangleAround(body, kind, input.scratch), farthestDepth(body), input);
}

Fit fitRectangle(const LightFrame& frame, OrientedRectangle rectangle, double farDepth, const FitInput& input)
{
    return fitRectangle(frame, rectangle, nearestCaster(frame, rectangle, input), farDepth, input);
}

Fit fitRectangleAsItIs(const LightFrame& frame, const OrientedRectangle& rectangle, double farDepth,
                       const FitInput& input)
{
    return fitSides(frame, rectangle, nearestCaster(frame, rectangle, input), farDepth, input);
}

Fit fitRectangle(const LightFrame& frame, OrientedRectangle rectangle, double nearDepth, double farDepth,
                 const FitInput& input, double leastScale)
{
    const double scale = std::max(leastScale, length(rectangle.centre) + length(rectangle.halfSize));
    const double room = kLeastRelativeHalfSize * scale, least = frame.isPerspective ? kLeastTangent : kLeastRoom;
    rectangle.halfSize = {std::max(kBorder * rectangle.halfSize.x + room, least),
                          std::max(kBorder * rectangle.halfSize.y + room, least)};

    return fitSides(frame, rectangle, nearDepth, farDepth, input);
}

} // namespace lixel
