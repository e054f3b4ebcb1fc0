// SPDX-License-Identifier: MIT
#include "lixel/plan/partition/plane_fit.h"

#include <cmath>

namespace lixel {
namespace {

constexpr double kBeside = 8, kSharp = 0.125; // tolerances
constexpr double kVeryNormal = 0.99996;       // cosine of half a degree
constexpr double kLeastWidth = 8;             // of what a plane is fitted to: tolerances, root mean square

struct Refit
{
    Plane plane;
    std::size_t count = 0; // of the samples that it was fitted to
};

// One step of least squares, distances counted in tolerances, over samples that lie on the plane so far. Heights are counted from
// that plane and places from one of the samples, so that nothing large cancels.
std::optional<Refit> refitted(std::span<const PlaneSample> group, const Plane& plane, double tolerances)
{
    const Vec3d u = anyPerpendicular(plane.normal), v = cross(plane.normal, u);
    std::size_t count = 0;
    Vec3d from;
    double s = 0, x = 0, y = 0, h = 0, xx = 0, xy = 0, yy = 0, hx = 0, hy = 0;
    for (const PlaneSample& sample : group) {
        if (!isOnPlane(sample, plane, tolerances)) continue;
        if (count++ == 0) from = sample.p;
        const double g = 1 / (sample.tolerance * sample.tolerance);
        const double px = dot(u, sample.p - from), py = dot(v, sample.p - from), ph = plane.signedDistance(sample.p);
        s += g, x += g * px, y += g * py, h += g * ph;
        xx += g * px * px, xy += g * px * py, yy += g * py * py, hx += g * ph * px, hy += g * ph * py;
    }
    if (count < kLeastPlaneSamples) return std::nullopt;
    x /= s, y /= s, h /= s;
    xx -= s * x * x, xy -= s * x * y, yy -= s * y * y, hx -= s * h * x, hy -= s * h * y;
    // The smaller eigenvalue is at least determinant / trace, and at most twice that.
    const double determinant = xx * yy - xy * xy, trace = xx + yy;
    if (!(determinant > kLeastWidth * kLeastWidth * double(count) * trace)) return std::nullopt;
    const double a = (hx * yy - hy * xy) / determinant, b = (hy * xx - hx * xy) / determinant;
    const Vec3d middle = from + x * u + y * v + (h - plane.signedDistance(from)) * plane.normal;
    return Refit{planeThrough(middle, normalized(plane.normal - a * u - b * v)), count};
}

// Steps until the samples stay the same.
std::optional<Refit> settled(std::span<const PlaneSample> group, std::optional<Refit> fit, double tolerances)
{
    constexpr int kMostSteps = 6;
    for (int step = 0; fit && step < kMostSteps; ++step) {
        const std::size_t before = fit->count;
        fit = refitted(group, fit->plane, tolerances);
        if (fit && fit->count == before) break;
    }
    return fit;
}

} // namespace

JudgedPlane judgePlane(std::span<const PlaneSample> group, const Plane& plane)
{
    JudgedPlane judged;
    judged.plane = plane;
    for (const PlaneSample& sample : group) {
        const double distance = std::abs(plane.signedDistance(sample.p)) / sample.tolerance;
        if (!isOnPlane(sample, plane)) {
            if (distance > kBeside) continue;
            ++judged.beside;
            judged.parallel += dot(sample.normal, plane.normal) >= kVeryNormal ? 1 : 0;
            continue;
        }
        ++judged.count;
        judged.sharp += distance <= kSharp ? 1 : 0;
        judged.weight += sample.weight;
        judged.miss += distance * distance;
    }
    if (judged.count > 0) judged.miss = std::sqrt(judged.miss / double(judged.count));
    return judged;
}

std::optional<JudgedPlane> settlePlane(std::span<const PlaneSample> group, const Plane& proposal)
{
    constexpr double kAtFirst = 4; // tolerances: a proposal through three noisy points
    if (const auto fit = settled(group, Refit{proposal, 0}, kSharp)) {
        const JudgedPlane judged = judgePlane(group, fit->plane);
        if (judged.isSharp()) return judged;
    }
    const auto fit = settled(group, refitted(group, proposal, kAtFirst), 1);
    if (!fit) return std::nullopt;
    return judgePlane(group, fit->plane);
}

} // namespace lixel
