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

// A body that goes less than this into a pixel only touches it, but for rounding: what fills the picture has no pixel more. No
// pixel's centre is lost.
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

// The direction on the picture of the line where two planes meet; nothing where no part of it before the viewer is in the picture.
std::optional<Vec2d> directionOnPicture(const LightFrame& frame, const Plane& plane, const Plane& other,
                                        const View& view)
{
    // Points of the line: start + t * along. They are points of the plane, so that their image is the viewer's.
    const Vec3d along = cross(plane.normal, other.normal);
    const double sine2 = dot(along, along);
    if (!(sine2 > kLeastSine * kLeastSine)) return std::nullopt;
    const Vec3d start = (1 / sine2) * cross(along, plane.offset * other.normal - other.offset * plane.normal);
    const auto image = [&](Vec4d p) {
        const Mat4d& m = frame.framedFromLocal;
        return Vec3d{dot(m.row(0), p), dot(m.row(1), p), dot(m.row(3), p)};
    };
    const Vec3d a = image(point(start)), b = image(direction((1 / std::sqrt(sine2)) * along));

    // Inside the picture: 0 <= x <= width w, 0 <= y <= height w, which holds for w >= 0 only.
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3d side :
         {Vec3d{1, 0, 0}, Vec3d{-1, 0, double(view.width)}, Vec3d{0, 1, 0}, Vec3d{0, -1, double(view.height)}}) {
        const double atStart = dot(side, a), slope = dot(side, b);
        if (slope > 0) low = std::max(low, -atStart / slope);
        else if (slope < 0) high = std::min(high, -atStart / slope);
        else if (atStart < 0) return std::nullopt;
    }
    if (!(low < high)) return std::nullopt;
    const Vec3d line = cross(a, b); // line.x x + line.y y + line.z w = 0
    const double size = length(Vec2d{line.x, line.y});
    if (!(size > 0)) return std::nullopt;
    return (1 / size) * Vec2d{-line.y, line.x};
}

OrientedRectangle twisted(const FramedBody& body, const FitInput& input)
{
    const PlaneOfCell& plane = *input.plane;
    if (plane.twist == Twist::Tight) return rectangleAround(body, RectangleKind::LeastArea, input.scratch);
    std::optional<Vec2d> along;
    if (plane.twist == Twist::Line && plane.throughLineLocal)
        along = directionOnPicture(body.frame, plane.planeLocal, *plane.throughLineLocal, input.view);
    return rectangleAround(body, along.value_or(Vec2d{1, 0}), input.scratch);
}

// What rounding brought over the picture's borders goes.
PixelRectangle withinPicture(const PixelRectangle& p, const View& view)
{
    const int x0 = std::clamp(p.x0, 0, view.width - 1), y0 = std::clamp(p.y0, 0, view.height - 1);
    return {x0, y0, std::clamp(p.x1, x0 + 1, view.width), std::clamp(p.y1, y0 + 1, view.height)};
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
    const int firstX = int(std::floor(x0 + kTouch)), firstY = int(std::floor(y0 + kTouch));
    return PixelRectangle{firstX, firstY, std::max(int(std::ceil(x1 - kTouch)), firstX + 1),
                          std::max(int(std::ceil(y1 - kTouch)), firstY + 1)};
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
        const OrientedRectangle rectangle = twisted(*body, input);
        out.lightClipFromLocal = fitRectangle(body->frame, rectangle, far, input).lightClipFromLocal;
        out.rounding = floatRounding(*body, rectangle);
        return out;
    }
    const auto around = wholePixelsAround(*body, kMostPixels);
    if (!around) return Unexpected{FitFailure::TooFewLixels};
    out.pixels = withinPicture(*around, input.view);
    const PixelRectangle& p = *out.pixels;
    const OrientedRectangle whole{
        {0.5 * (p.x0 + p.x1), 0.5 * (p.y0 + p.y1)}, {1, 0}, {0.5 * p.width(), 0.5 * p.height()}};
    out.lightClipFromLocal = fitRectangleAsItIs(body->frame, whole, far, input).lightClipFromLocal;
    out.rounding = floatRounding(*body, whole);
    return out;
}

} // namespace lixel
