// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/stable.h"

#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/uniform.h"
#include "lixel/plan/fit/visible_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace lixel {
namespace {

// Turns that divide a circle into eighths: a camera that looks along an axis, or half-way between two, is in the middle of a step.
constexpr int kTurnsOfCircle = 88;
constexpr double kTurnStep = 2 * std::numbers::pi / kTurnsOfCircle; // radians
constexpr double kGridPerDiagonal = 1.0 / 20;
constexpr double kWidestHeld = 1.5; // radians of half angle

// Borders lie where round numbers do not: the held view's opening is rounded up to a grid from above 0.6 of its steps, and the near
// side down from below 2^-0.4 = 0.76 of powers of two.
constexpr double kAngleGrid = 1.0 / 2048; // radians
constexpr double kAboveAngle = 0.4;       // steps of it
constexpr double kBelowOctave = 0.4;

// How far the middle of a picture may be off the line of sight by jitter, and in what steps it counts beyond that.
constexpr double kJitter = 0.51;            // pixels
constexpr double kOffCentreStep = 1.0 / 32; // of half the picture

struct Sphere
{
    Vec3d centre;
    double radius = 0;
};

// The four corners of the picture at a depth, Local.
std::array<Vec3d, 4> cornersAt(const Mat4d& localFromClip, const ViewDepth& depth, double at)
{
    std::array<Vec3d, 4> corners;
    for (int i = 0; i < 4; ++i) {
        const double x = i & 1 ? 1 : -1, y = i & 2 ? 1 : -1;
        const Vec4d near = localFromClip * Vec4d{x, y, -1, 1}, beyond = localFromClip * Vec4d{x, y, 0, 1};
        const Vec3d from = xyz(near) / near.w, to = xyz(beyond) / beyond.w;
        const double d0 = depth.of(from), d1 = depth.of(to);
        corners[std::size_t(i)] = from + ((at - d0) / (d1 - d0)) * (to - from);
    }
    return corners;
}

// The least depth on the near side and the greatest on the far side: of oblique ones, at a corner.
DepthSpan betweenSides(const Mat4d& localFromClip, const ViewDepth& depth)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    DepthSpan span{kInfinity, -kInfinity};
    for (int i = 0; i < 4; ++i) {
        const double x = i & 1 ? 1 : -1, y = i & 2 ? 1 : -1;
        const Vec4d near = localFromClip * Vec4d{x, y, -1, 1}, far = localFromClip * Vec4d{x, y, 1, 1};
        span.nearest = std::min(span.nearest, depth.of(xyz(near) / near.w));
        span.farthest = std::max(span.farthest, far.w > 0 ? depth.of(xyz(far) / far.w) : kInfinity);
    }
    return span;
}

double distanceTo(const Box& box, Vec3d p)
{
    const auto beyond = [](double low, double high, double x) { return std::max({low - x, x - high, 0.0}); };
    return length(
        {beyond(box.min.x, box.max.x, p.x), beyond(box.min.y, box.max.y, p.y), beyond(box.min.z, box.max.z, p.z)});
}

// The slice of depths that a region has of the view: cut by those of its planes that lie across the line of sight.
DepthSpan sliceOf(const FitInput& input, const ViewDepth& depth)
{
    DepthSpan slice = stableDepths(input);
    for (const Plane& plane : input.cellLocal) {
        const double cosine = dot(plane.normal, depth.forward);
        if (cosine > 1 - 1e-9) slice.nearest = std::max(slice.nearest, depth.offset - plane.offset);
        if (cosine < -1 + 1e-9) slice.farthest = std::min(slice.farthest, depth.offset + plane.offset);
    }
    return {slice.nearest, std::max(slice.nearest, slice.farthest)};
}

// How far the middle of something of a picture is off the line of sight, as it counts: `jitter`, which is moved by that and no change,
// and what is farther off in coarse steps besides, which jitter seldom crosses.
double countedMiddle(double middle, double jitter, double extent)
{
    const double step = kOffCentreStep * extent;
    return step > 0 ? jitter + step * std::ceil(std::max(middle - jitter, 0.0) / step) : jitter;
}

// A sphere with its centre on the slice's axis that holds all eight corners, the smallest but for the axis, which jitter moves: its
// radius is of corners as far from the axis and along the line of sight as they are, and is rounded up a little so that it does not
// change by rounding.
std::optional<Sphere> sphereAround(const FitInput& input)
{
    const auto localFromClip = inverse(clipFromLocal(input.view, input.originWorld));
    if (!localFromClip) return std::nullopt;
    const ViewDepth depth = viewDepth(input.view, input.originWorld);
    const auto [first, last] = sliceOf(input, depth);
    const std::array<Vec3d, 4> near = cornersAt(*localFromClip, depth, first),
                               far = cornersAt(*localFromClip, depth, last);
    const auto middleOf = [](const std::array<Vec3d, 4>& c) { return 0.25 * (c[0] + c[1] + c[2] + c[3]); };
    const auto farthestFrom = [](Vec3d p, const std::array<Vec3d, 4>& c) {
        double r = 0;
        for (const Vec3d& q : c) r = std::max(r, length(q - p));
        return r;
    };
    const Vec3d from = middleOf(near), to = middleOf(far);
    const double span = last - first, rn = farthestFrom(from, near), rf = farthestFrom(to, far);
    const double share = span > 0 ? std::clamp(0.5 + (rf * rf - rn * rn) / (2 * span * span), 0.0, 1.0) : 0;
    const double pixel = 2 * std::abs(rf - rn) / std::min(input.view.width, input.view.height);
    const double aside = countedMiddle(length(to - from - span * depth.forward), pixel, std::abs(rf - rn));

    Sphere sphere{from + share * (to - from), 0};
    sphere.radius = std::max(std::hypot(share * span, share * aside + rn),
                             std::hypot((1 - share) * span, (1 - share) * aside + rf));
    int exponent = 0;
    const double mantissa = std::frexp(sphere.radius, &exponent);
    sphere.radius = std::ldexp(std::ceil(mantissa * 65536 + 0.5) / 65536, exponent);
    return sphere;
}

double snapped(double x, double step) { return step * std::round(x / step); }

Vec3d snapped(Vec3d p, double step) { return {snapped(p.x, step), snapped(p.y, step), snapped(p.z, step)}; }

// Steps of turns, half a circle to the left as half a circle to the right.
int turnsOf(double angle)
{
    const int turns = int(std::round(angle / kTurnStep));
    return 2 * turns <= -kTurnsOfCircle ? turns + kTurnsOfCircle : turns;
}

// How a camera is turned, on a grid of angles about the y axis: yaw, then pitch, then roll about the line of sight.
struct Turn
{
    Vec3d forward, up;
};

std::optional<Turn> snappedAboutY(Vec3d forward, Vec3d right, int steepest)
{
    const int pitch = turnsOf(std::asin(std::clamp(forward.y, -1.0, 1.0)));
    if (std::abs(pitch) > steepest) return std::nullopt;
    const double acrossSquared = forward.x * forward.x + forward.z * forward.z;
    const Vec3d level = (1 / std::sqrt(acrossSquared)) * Vec3d{-forward.z, 0, forward.x};
    const double roll = std::atan2(dot(right, cross(level, forward)), dot(right, level));

    const double y = kTurnStep * turnsOf(std::atan2(forward.x, forward.z)), p = kTurnStep * pitch,
                 r = kTurnStep * turnsOf(roll);
    const Vec3d f{std::cos(p) * std::sin(y), std::sin(p), std::cos(p) * std::cos(y)};
    const Vec3d snappedLevel{-std::cos(y), 0, std::sin(y)};
    return Turn{f, std::cos(r) * cross(snappedLevel, f) - std::sin(r) * snappedLevel};
}

// About the world's y axis; for those that look more along it than across, about its z axis, since near an axis every small turn
// is a large one about it. The step of pitch tells which, so that there are no borders besides those of steps.
Turn snappedTurn(Vec3d forward, Vec3d right)
{
    if (const auto turn = snappedAboutY(forward, right, kTurnsOfCircle / 8)) return *turn;
    const auto zUp = [](Vec3d v) { return Vec3d{v.y, v.z, v.x}; };
    const auto fromZUp = [](Vec3d v) { return Vec3d{v.z, v.x, v.y}; };
    const Turn turn = *snappedAboutY(zUp(forward), zUp(right), kTurnsOfCircle / 4);
    return {fromZUp(turn.forward), fromZUp(turn.up)};
}

// From the eye to the four corners of the picture at the depth of 1. Needs a perspective view.
std::array<Vec3d, 4> cornerRays(const Mat4d& clip, Vec3d forward)
{
    std::array<Vec3d, 4> rays;
    const Vec3d w = xyz(clip.row(3));
    for (int i = 0; i < 4; ++i) {
        const double x = i & 1 ? 1 : -1, y = i & 2 ? 1 : -1;
        const Vec3d ray = cross(xyz(clip.row(0)) - x * w, xyz(clip.row(1)) - y * w); // in the planes of two sides
        rays[std::size_t(i)] = (1 / dot(ray, forward)) * ray;
    }
    return rays;
}

// The least depth of the near side, which is at a corner.
double nearestOnRays(const View& view, const std::array<Vec3d, 4>& rays)
{
    const Vec4d fromNear = view.clipFromAnchored.row(2) + view.clipFromAnchored.row(3);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3d& ray : rays)
        nearest = std::min(nearest, -dot(fromNear, view.eyeAnchored) / dot(xyz(fromNear), ray));
    return nearest;
}

// How far a picture reaches from its line of sight, to the side and upwards: radians.
struct HalfAngles
{
    double side = 0, up = 0;
};

// Those of a picture around the line of sight that holds it, rounded up. Jitter moves the picture's middle, and half its extent not at all.
HalfAngles halfAngles(const View& view, const std::array<Vec3d, 4>& rays, Vec3d right, Vec3d up)
{
    const auto along = [&](Vec3d axis, int pixels) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const Vec3d& ray : rays) {
            least = std::min(least, dot(ray, axis));
            most = std::max(most, dot(ray, axis));
        }
        const double extent = 0.5 * (most - least), middle = 0.5 * std::abs(most + least);
        const double reach = extent + countedMiddle(middle, kJitter * 2 * extent / pixels, extent);
        return kAngleGrid * std::ceil(std::atan(reach) / kAngleGrid + kAboveAngle);
    };
    return {along(right, view.width), along(up, view.height)};
}

// Those of a picture that still holds the other when they are turned apart by half a step of roll, which moves its corners by that
// times their sine, and then of yaw and pitch, whose axes are at right angles. A side plane tilted by t lets in directions at an angle e
// above its middle by asin(sin t cos e) only, so it is tilted by asin(sin(turn) / cos e).
HalfAngles widened(const HalfAngles& half)
{
    const double corner = std::atan(std::hypot(std::tan(half.side), std::tan(half.up)));
    const double turn = 0.5 * kTurnStep * (std::sqrt(2.0) + std::sin(corner));
    const auto tilted = [&](double angle, double across) {
        return angle + std::asin(std::min(std::sin(turn) / std::cos(std::min(across + turn, kWidestHeld)), 1.0));
    };
    return {tilted(half.side, half.up), tilted(half.up, half.side)};
}

} // namespace

FitResult fitStable(const FitInput& input)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    findVisiblePoints(input, input.scratch.points);
    if (input.scratch.points.empty()) return Unexpected{FitFailure::NothingInView};
    if (input.light.kind != LightKind::Directional) return fitUniform(input);
    const auto sphere = sphereAround(input);
    if (!sphere || !std::isfinite(sphere->radius) || sphere->radius >= 0.5 * input.sceneLocal.diagonal()) {
        FitInput whole = input;
        whole.cellLocal.clear(); // the region's borders move with the camera
        return fitUniform(whole);
    }
    const LightFrame frame = lightFrame(input.light, input.originWorld, input.light.directionWorld);
    double near = std::numeric_limits<double>::infinity(), far = -near;
    for (const Vec3d& corner : input.sceneLocal.corners()) {
        const double depth = dot(frame.framedFromLocal.row(2), point(corner));
        near = std::min(near, depth);
        far = std::max(far, depth);
    }
    const OrientedRectangle square{onLightPlane(frame, sphere->centre), {1, 0}, {sphere->radius, sphere->radius}};
    // Room for the rounding of coordinates, too, is the same wherever the square is, or, far from the origin, within an octave.
    const double away = length(square.centre), reach = 4 * sphere->radius;
    const double scale = 2 * (away <= reach ? reach : std::exp2(std::ceil(std::log2(away))));
    Fit fit = fitRectangle(frame, square, near, far, input, scale);
    fit.snapsToWorld = true;
    return fit;
}

DepthSpan stableDepths(const FitInput& input)
{
    const ViewDepth depth = viewDepth(input.view, input.originWorld);
    const auto localFromClip = inverse(clipFromLocal(input.view, input.originWorld));
    if (!localFromClip) return {0, input.sceneLocal.diagonal()};
    const Vec4d near = *localFromClip * Vec4d{0, 0, -1, 1};
    const Vec3d nearLocal = xyz(near) / near.w;
    // A camera over flat ground is just outside the scene's box; that is no distance yet.
    const double diagonal = input.sceneLocal.diagonal(), away = distanceTo(input.sceneLocal, nearLocal) - diagonal / 8;
    const DepthSpan sides = betweenSides(*localFromClip, depth);
    DepthSpan range{sides.nearest, depth.of(nearLocal) + 1.125 * diagonal};
    if (away > 0) range.farthest += std::exp2(0.5 * std::ceil(2 * std::log2(away)));
    return {range.nearest, std::min(range.farthest, sides.farthest)};
}

std::optional<View> heldView(const View& view, double gridStep)
{
    const ViewDepth depth = viewDepth(view, view.anchorWorld);
    if (!depth.isPerspective || !(gridStep > 0)) return std::nullopt;

    const std::array<Vec3d, 4> rays = cornerRays(view.clipFromAnchored, depth.forward);
    const Vec3d right = normalized(rays[1] - rays[0]);
    const HalfAngles half = widened(halfAngles(view, rays, right, cross(right, depth.forward)));
    const double nearest = std::max(1e-9 * gridStep, nearestOnRays(view, rays));
    if (!(half.side <= kWidestHeld) || !(half.up <= kWidestHeld) || !std::isfinite(nearest)) return std::nullopt;

    // From an eye so far back that half a step aside along all three axes stays inside. What the camera sees is at least as far before it
    // as that eye is behind such a step; nothing nearer may make the map's perspective stronger. Half of the near depth: a corner
    // of the near side lies less deep for a camera that looks a step aside.
    const Turn turned = snappedTurn(depth.forward, right);
    const double aside = std::sqrt(0.75) * gridStep, back = aside / std::sin(std::min(half.side, half.up));
    const Vec3d held = snapped(view.anchorWorld + xyz(view.eyeAnchored), gridStep) - back * turned.forward;
    const double octave = std::floor(std::log2(nearest) + kBelowOctave) - kBelowOctave;
    const double near = back - aside + std::exp2(octave - 1);
    View result = perspectiveView(held, held + turned.forward, turned.up, 2 * half.up, near,
                                  std::numeric_limits<double>::infinity(), view.height, view.height);
    for (double& x : result.clipFromAnchored.m[0]) x *= std::tan(half.up) / std::tan(half.side);
    return result;
}

FitResult fitHeld(const FitInput& input, FitResult (*fit)(const FitInput&))
{
    const auto view = heldView(input.view, kGridPerDiagonal * input.sceneLocal.diagonal());
    if (!view) return fitStable(input);
    FitInput held{*view,         input.light,    input.originWorld, input.casterBoxesWorld, input.sceneLocal,
                  input.scratch, input.cellLocal};
    findVisiblePoints(held, held.scratch.points);
    if (held.scratch.points.empty()) return Unexpected{FitFailure::NothingInView};
    return fit(held);
}

} // namespace lixel
