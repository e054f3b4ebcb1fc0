// SPDX-License-Identifier: MIT
#include "studies/random_plane.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace lixel::app {
namespace {

constexpr double kLeastElevation = 1e-3, kRightAngle = std::numbers::pi / 2;

// Of the picture, that a triangle of the plane must be: a rasterizer makes slopes of slivers by differences that cancel.
constexpr double kLeastShare = 0.03;

class Random
{
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double uniform(double low, double high) { return low + (high - low) * (double(engine_() >> 11) * 0x1p-53); }
    double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    bool chance(double probability) { return uniform(0, 1) < probability; }
    Vec3d onSphere()
    {
        const double z = uniform(-1, 1), a = uniform(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
        return {r * std::cos(a), r * std::sin(a), z};
    }

private:
    std::mt19937_64 engine_;
};

// A direction at an elevation over the plane.
Vec3d above(Random& random, Vec3d normal, double elevation)
{
    const Vec3d u = anyPerpendicular(normal), v = cross(normal, u);
    const double a = random.uniform(0, 2 * std::numbers::pi);
    return std::cos(elevation) * (std::cos(a) * u + std::sin(a) * v) + std::sin(elevation) * normal;
}

// Looks towards a place, which is not in the middle of the picture; the frustum may be off-centre.
View randomView(Random& random, Vec3d eye, Vec3d target, double radius, std::map<std::string, double>& parameters)
{
    const int width = int(random.uniform(64, 513)), height = int(random.uniform(64, 513));
    const double fovy = random.uniform(0.3, 1.6), near = radius * random.logUniform(1e-3, 1);
    const double far = random.chance(0.5) ? INFINITY : near + radius * random.logUniform(0.1, 100);
    const Vec3d aside = 0.4 * fovy * length(target - eye) * random.uniform(0, 1) * random.onSphere();
    const Vec3d towards = target + aside, up = random.onSphere();
    const bool isParallel = random.chance(0.1);
    View view = isParallel ? orthographicView(eye, towards, up, radius * random.uniform(0.3, 3), -radius, 10 * radius,
                                              width, height)
                           : perspectiveView(eye, towards, up, fovy, near, far, width, height);
    if (random.chance(0.3)) {
        Mat4d& clip = view.clipFromAnchored;
        clip.setRow(0, clip.row(0) + random.uniform(-0.8, 0.8) * clip.row(3));
        clip.setRow(1, clip.row(1) + random.uniform(-0.8, 0.8) * clip.row(3));
    }
    parameters["width_pixels"] = width;
    parameters["height_pixels"] = height;
    parameters["near_radii"] = near / radius;
    parameters["fovy_radians"] = isParallel ? 0 : fovy;
    return view;
}

Light randomLight(Random& random, Vec3d target, Vec3d normal, double radius, std::map<std::string, double>& parameters)
{
    Light light;
    light.kind = LightKind(int(random.uniform(0, 3)));
    const double elevation = random.logUniform(kLeastElevation, kRightAngle);
    const double distance = radius * random.logUniform(0.1, 1e6);
    const Vec3d towards = above(random, normal, elevation);
    light.directionWorld = -towards;
    light.positionWorld = target + distance * towards;
    light.coneAngle = random.uniform(0.5, 3);
    parameters["light_elevation_radians"] = elevation;
    parameters["light_radii"] = light.kind == LightKind::Directional ? 0 : distance / radius;
    return light;
}

// Floats are counted from a place near the eye, on a grid.
Vec3d snapped(Vec3d eyeWorld, double radius)
{
    const double step = std::exp2(std::floor(std::log2(radius / 1024)));
    return {std::round(eyeWorld.x / step) * step, std::round(eyeWorld.y / step) * step,
            std::round(eyeWorld.z / step) * step};
}

// Of the plane's points along a grid of the picture the three that span most of it, seen within two radii. Nothing where they span next to
// nothing.
std::optional<std::array<Vec3d, 3>> largestTriangle(const PlaneConfiguration& c, const Plane& planeLocal)
{
    constexpr int kSteps = 5;
    std::vector<Vec3d> points;
    std::vector<Vec2d> pixels;
    for (int j = 0; j <= kSteps; ++j)
        for (int i = 0; i <= kSteps; ++i) {
            // Inside the picture: where its sides cut a triangle, rasterizers make slivers of a thousandth of a pixel, whose
            // slopes are rounding.
            const Vec2d pixel{(0.02 + 0.96 * i / kSteps) * c.view.width, (0.02 + 0.96 * j / kSteps) * c.view.height};
            const auto p = seenAt(c.view, c.originWorld, planeLocal, pixel);
            if (!p || length(*p) > 2 * c.radius) continue;
            points.push_back(*p);
            pixels.push_back(pixel);
        }
    double most = kLeastShare * c.view.width * c.view.height;
    std::optional<std::array<Vec3d, 3>> best;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (std::size_t k = 0; k < j; ++k) {
                const double area = 0.5 * std::abs(cross(pixels[j] - pixels[i], pixels[k] - pixels[i]));
                if (area <= most) continue;
                most = area;
                best = {points[i], points[j], points[k]};
            }
    return best;
}

// Nothing where the viewer sees too little of the plane.
std::optional<PlaneConfiguration> tryPlane(Random& random)
{
    PlaneConfiguration out;
    out.radius = random.logUniform(0.1, 1e3);
    const double fromOrigin = random.chance(0.2) ? 0 : random.logUniform(1, 1e5);
    const Vec3d middle = fromOrigin * random.onSphere(), normal = random.onSphere();
    const double elevation = random.logUniform(kLeastElevation, kRightAngle);
    const double distance = out.radius * random.logUniform(0.05, 1);
    const Vec3d eye = middle + distance * above(random, normal, elevation);
    out.view = randomView(random, eye, middle, out.radius, out.parameters);
    out.light = randomLight(random, middle, normal, out.radius, out.parameters);
    out.originWorld = snapped(eye, out.radius);

    const auto corners = largestTriangle(out, planeThrough(middle - out.originWorld, normal));
    if (!corners) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) out.triangleLocal[i] = toFloat((*corners)[i]);
    const Vec3d a = toDouble(out.triangleLocal[0]), b = toDouble(out.triangleLocal[1]),
                c = toDouble(out.triangleLocal[2]);
    const Vec3d across = normalized(cross(b - a, c - a));
    out.planeLocal = planeThrough(a, random.chance(0.5) ? across : -across);

    out.parameters["radius_units"] = out.radius;
    out.parameters["from_origin_units"] = fromOrigin;
    out.parameters["eye_elevation_radians"] = elevation;
    out.parameters["eye_radii"] = distance / out.radius;
    return out;
}

} // namespace

std::optional<Vec3d> seenAt(const View& view, Vec3d originWorld, const Plane& planeLocal, Vec2d pixel)
{
    const auto anchoredFromClip = inverse(view.clipFromAnchored);
    if (!anchoredFromClip) return std::nullopt;
    const double ndcX = 2 * pixel.x / view.width - 1, ndcY = 2 * pixel.y / view.height - 1;
    const Vec4d far = *anchoredFromClip * Vec4d{ndcX, ndcY, 0.5, 1}, eye = view.eyeAnchored;
    const Vec3d start = eye.w > 0 ? xyz(eye) : xyz(far) / far.w;
    const Vec3d along = eye.w > 0 ? xyz(far) / far.w - start : -xyz(eye);
    const Vec3d anchorLocal = view.anchorWorld - originWorld;
    const double height = planeLocal.signedDistance(anchorLocal) + dot(planeLocal.normal, start);
    const Vec3d p = start - height / dot(planeLocal.normal, along) * along + anchorLocal;
    const Vec4d clip = clipFromLocal(view, originWorld) * point(p);
    return isFinite(p) && clip.w > 0 && std::abs(clip.z) <= clip.w ? std::optional(p) : std::nullopt;
}

PlaneConfiguration randomPlane(std::uint64_t seed, int number)
{
    std::seed_seq mixed{std::uint32_t(seed), std::uint32_t(seed >> 32), std::uint32_t(number)};
    std::array<std::uint32_t, 2> words{};
    mixed.generate(words.begin(), words.end());
    const std::uint64_t high = words[0], low = words[1];
    Random random(high << 32 | low);
    for (;;)
        if (auto configuration = tryPlane(random)) return *configuration;
}

} // namespace lixel::app
