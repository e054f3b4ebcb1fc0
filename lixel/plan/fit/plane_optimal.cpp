// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/plane_optimal.h"

#include "lixel/plan/fit/visible_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lixel {
namespace {

// Sines below this are a light or an eye in the plane.
constexpr double kLeastSine = 1e-7;

// Receivers nearer to the light than this part of the farthest are too near for one map's depths (see fitRectangle).
constexpr double kLeastNearPerFar = 1e-4;

// Pixels within this of a body's border count as touched by it, for rounding.
constexpr double kTouch = 1e-6;

constexpr int kMostPixels = 32768;

// Homogeneous place of the light, of a size near 1, against an anchor; w = 0 for directions.
Vec4d lightAt(const Light& light, Vec3d anchorWorld)
{
    if (light.kind == LightKind::Directional) return direction(-light.directionWorld);
    const Vec3d p = light.positionWorld - anchorWorld;
    const double away = length(p);
    return away > 1 ? (1 / away) * point(p) : point(p);
}

Vec4d asRow(const Plane& plane) { return {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset}; }

// How far above the plane the light stands, as a sine seen from a scene about the anchor.
double sineAbove(const Plane& planeAnchored, Vec4d light, double sceneSize)
{
    return dot(asRow(planeAnchored), light) / (length(xyz(light)) + std::abs(light.w) * sceneSize);
}

Plane moved(const Plane& plane, Vec3d by) { return {plane.normal, plane.offset - dot(plane.normal, by)}; }

// Sides of the picture, as half-spaces of Local space through the light, inside positive.
std::array<Plane, 4> pictureSides(const LightFrame& frame, const View& view)
{
    const Vec4d x = frame.framedFromLocal.row(0), y = frame.framedFromLocal.row(1), w = frame.framedFromLocal.row(3);
    const auto plane = [](Vec4d row) {
        const double size = length(xyz(row));
        return size > 0 ? Plane{(1 / size) * xyz(row), row.w / size} : Plane{{}, 1};
    };
    return {plane(x), plane(double(view.width) * w - x), plane(y), plane(double(view.height) * w - y)};
}

// The direction on the picture of the image of a plane through the light; nothing where it is not across the picture.
std::optional<Vec2d> directionOnPicture(const LightFrame& frame, const Plane& throughLight, const View& view)
{
    // Its row is a combination a x + b y + c w of the frame's, by least squares on four numbers; its image runs at right angles to (a, b).
    const std::array<Vec4d, 3> rows{frame.framedFromLocal.row(0), frame.framedFromLocal.row(1),
                                    frame.framedFromLocal.row(3)};
    const Vec4d cut = asRow(throughLight);
    std::array<double, 3> size;
    for (std::size_t i = 0; i < 3; ++i) size[i] = std::sqrt(dot(rows[i], rows[i]));
    if (!(size[0] > 0 && size[1] > 0 && size[2] > 0)) return std::nullopt;
    const auto products = [&](std::size_t i) {
        return Vec3d{dot(rows[i], rows[0]) / size[0], dot(rows[i], rows[1]) / size[1],
                     dot(rows[i], rows[2]) / size[2]} /
               size[i];
    };
    const Vec3d first = products(0), second = products(1), third = products(2); // normal equations, scaled by rows
    const Vec3d right{dot(rows[0], cut) / size[0], dot(rows[1], cut) / size[1], dot(rows[2], cut) / size[2]};
    const double determinant = dot(first, cross(second, third));
    if (!(std::abs(determinant) > 1e-20)) return std::nullopt;
    const Vec3d scaled{dot(right, cross(second, third)) / determinant, dot(right, cross(third, first)) / determinant,
                       dot(right, cross(first, second)) / determinant};
    const double a = scaled.x / size[0], b = scaled.y / size[1], c = scaled.z / size[2];
    // Across the picture: corners on both sides.
    const double w = view.width, h = view.height;
    const auto [low, high] = std::minmax({c, a * w + c, b * h + c, a * w + b * h + c});
    if (!(low < 0 && high > 0)) return std::nullopt;
    return (1 / length(Vec2d{a, b})) * Vec2d{-b, a};
}

OrientedRectangle twisted(const FramedBody& body, const FitInput& input)
{
    const PlaneOfCell& plane = *input.plane;
    if (plane.twist == Twist::Tight) return rectangleAround(body, RectangleKind::LeastArea, input.scratch);
    std::optional<Vec2d> along;
    if (plane.twist == Twist::Line && plane.throughLineLocal)
        along = directionOnPicture(body.frame, *plane.throughLineLocal, input.view);
    return rectangleAround(body, along.value_or(Vec2d{1, 0}), input.scratch);
}

// What the map must hold: of the region what may be seen, or its view samples, within more planes of the light.
void findPoints(const FitInput& input, bool isOfSamples, std::span<const Plane> within, std::vector<Vec3d>& points)
{
    if (!isOfSamples) {
        FitInput region = input;
        for (const Plane& side : within) region.cellLocal.push_back(side);
        findVisiblePoints(region, points);
        return;
    }
    points.clear();
    for (const Vec3d& p : input.seenLocal)
        if (std::all_of(within.begin(), within.end(), [&](const Plane& side) { return side.signedDistance(p) >= 0; }))
            points.push_back(p);
}

// The half-space in which w is not next to nothing against what it is elsewhere; nothing where it is not so anywhere.
std::optional<Plane> awayFromLight(const LightFrame& frame, std::span<const Vec3d> points)
{
    const Vec4d w = frame.framedFromLocal.row(3);
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const Vec3d& p : points) {
        const double value = dot(w, point(p));
        least = std::min(least, value), most = std::max(most, value);
    }
    const double limit = kLeastNearPerFar * most;
    if (!(least < limit)) return std::nullopt;
    const double size = length(xyz(w));
    return Plane{(1 / size) * xyz(w), (w.w - limit) / size};
}

} // namespace

Expected<LightFrame, FitFailure> planeOptimalFrame(const View& view, const Light& light, Vec3d originWorld,
                                                   const Plane& planeLocal, double sceneSize)
{
    // About the eye, where floats of a far world have not yet lost what is near the eye.
    const Vec3d anchorLocal = view.anchorWorld - originWorld;
    Plane plane = moved(planeLocal, -anchorLocal);
    const Vec4d l = lightAt(light, view.anchorWorld);
    if (std::abs(sineAbove(plane, l, sceneSize)) < kLeastSine) return Unexpected{FitFailure::LightInPlane};
    if (std::abs(sineAbove(plane, view.eyeAnchored, sceneSize)) < kLeastSine) return Unexpected{FitFailure::EyeInPlane};
    if (dot(asRow(plane), l) < 0) plane = {-plane.normal, -plane.offset};

    const Vec4d pi = asRow(plane);
    const double piL = dot(pi, l);
    const auto alongLight = [&](Vec4d row) { return piL * row - dot(row, l) * pi; };
    const Mat4d& clip = view.clipFromAnchored;
    const Vec4d w = clip.row(3);
    const auto toLocal = [&](Vec4d row) {
        row.w -= dot(xyz(row), anchorLocal);
        return row;
    };
    LightFrame frame;
    frame.isPerspective = light.kind != LightKind::Directional;
    if (frame.isPerspective) frame.apexLocal = light.positionWorld - originWorld;
    const Vec4d rowX = toLocal(alongLight(0.5 * view.width * (clip.row(0) + w)));
    const Vec4d rowY = toLocal(alongLight(0.5 * view.height * (clip.row(1) + w)));
    const Vec4d rowW = toLocal(alongLight(w));
    frame.framedFromLocal =
        Mat4d::fromRows(rowX, rowY, frame.isPerspective ? rowW : direction(light.directionWorld), rowW);
    return frame;
}

std::optional<PixelRectangle> wholePixelsAround(const FramedBody& body, int most)
{
    double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;
    for (const Vec3d& p : body.corners) {
        const Vec2d pixel = onLightPlane(body.frame, p);
        x0 = std::min(x0, pixel.x), x1 = std::max(x1, pixel.x);
        y0 = std::min(y0, pixel.y), y1 = std::max(y1, pixel.y);
    }
    if (!(x1 - x0 < most && y1 - y0 < most && std::abs(x0) < 1e9 && std::abs(y0) < 1e9)) return std::nullopt;
    return PixelRectangle{int(std::floor(x0 - kTouch)), int(std::floor(y0 - kTouch)), int(std::ceil(x1 + kTouch)),
                          int(std::ceil(y1 + kTouch))};
}

FitResult fitPlaneOptimal(const FitInput& input, const PlaneOptimalFit& fit)
{
    LX_ASSERT(input.plane);
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    if (fit.isOfSamples && !input.hasViewSamples) return Unexpected{FitFailure::NoViewSamples};
    const Plane& plane = input.plane->planeLocal;
    const auto frame =
        planeOptimalFrame(input.view, input.light, input.originWorld, plane, input.sceneLocal.diagonal());
    if (!frame) return Unexpected{frame.error()};
    const double ofEye = dot(asRow(plane), eyeLocal(input.view, input.originWorld));
    const double ofLight = dot(asRow(plane), lightAt(input.light, input.originWorld));
    if (ofEye * ofLight < 0) return Unexpected{FitFailure::PlaneFacesAway};

    FixedVector<Plane, 5> within;
    for (const Plane& side : pictureSides(*frame, input.view)) within.push_back(side);
    std::vector<Vec3d>& points = input.scratch.points;
    findPoints(input, fit.isOfSamples, {within.data(), within.size()}, points);
    Fit out;
    out.isOfSamples = fit.isOfSamples;
    for (const Plane& side : within) out.holdsLocal.push_back(side);
    out.narrowedToLocal = awayFromLight(*frame, points);
    if (out.narrowedToLocal) {
        within.push_back(*out.narrowedToLocal);
        findPoints(input, fit.isOfSamples, {within.data(), within.size()}, points);
    }
    const auto body = framedIn(*frame, points, input.scratch);
    if (!body) return Unexpected{FitFailure::NothingInView};

    const double far = farthestDepth(*body);
    if (!input.wantsWholePixels) {
        out.lightClipFromLocal = fitRectangle(body->frame, twisted(*body, input), far, input).lightClipFromLocal;
        return out;
    }
    out.pixels = wholePixelsAround(*body, kMostPixels);
    if (!out.pixels) return Unexpected{FitFailure::TooFewLixels};
    const PixelRectangle& p = *out.pixels;
    const OrientedRectangle whole{
        {0.5 * (p.x0 + p.x1), 0.5 * (p.y0 + p.y1)}, {1, 0}, {0.5 * p.width(), 0.5 * p.height()}};
    out.lightClipFromLocal = fitRectangleAsItIs(body->frame, whole, far, input).lightClipFromLocal;
    return out;
}

} // namespace lixel
