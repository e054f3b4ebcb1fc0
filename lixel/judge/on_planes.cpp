// SPDX-License-Identifier: MIT
#include "lixel/judge/on_planes.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

constexpr double kFloatRounding = 4 * 0x1p-24; // of three coordinates and their sum
constexpr double kSameNormal = 1 - 5e-7;       // cosine of a thousandth of a radian

// Crossing number; corners may run either way round.
bool isInPolygon(const NamedPlane& plane, Vec3d pointWorld)
{
    if (plane.polygonWorld.size() < 3) return true;
    const Vec3d u = anyPerpendicular(plane.normalWorld), v = cross(plane.normalWorld, u);
    const auto flat = [&](Vec3d p) { return Vec2d{dot(u, p), dot(v, p)}; };
    const Vec2d p = flat(pointWorld);
    bool isInside = false;
    Vec2d a = flat(plane.polygonWorld.back());
    for (const Vec3d& corner : plane.polygonWorld) {
        const Vec2d b = flat(corner);
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) isInside = !isInside;
        a = b;
    }
    return isInside;
}

bool liesOn(const NamedPlane& plane, const ViewSamples& samples, std::size_t i)
{
    const Vec3d p = toDouble(samples.positionLocal[i]), n = plane.normalWorld;
    if (std::abs(dot(n, toDouble(samples.normal[i]))) < kSameNormal) return false;
    const Vec3d at = plane.pointWorld - samples.originWorld;
    const double slack = kFloatRounding * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z));
    return std::abs(dot(n, p - at)) <= slack && isInPolygon(plane, p + samples.originWorld);
}

} // namespace

std::vector<int> planeOfSamples(const ViewSamples& samples, std::span<const NamedPlane> planes)
{
    std::vector<int> out(samples.size(), kOnNoPlane);
    for (std::size_t i = 0; i < samples.size(); ++i)
        for (std::size_t p = 0; p < planes.size() && out[i] == kOnNoPlane; ++p)
            if (liesOn(planes[p], samples, i)) out[i] = int(p);
    return out;
}

std::vector<ZoneScore> scoreOfPlanes(std::span<const int> planeOf, std::size_t planes, std::span<const Zone> zones,
                                     std::span<const float> visibility, std::span<const float> exactVisibility)
{
    LX_ASSERT(planeOf.size() == zones.size() && zones.size() == visibility.size() &&
              visibility.size() == exactVisibility.size());
    std::vector<ZoneScore> out(planes + 1);
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const Verdict verdict = verdictOf(zones[i], visibility[i], exactVisibility[i]);
        if (verdict == Verdict::NotCounted) continue;
        ZoneScore& count = out[planeOf[i] == kOnNoPlane ? planes : std::size_t(planeOf[i])];
        ++count.samples;
        count.misclassified += verdict != Verdict::Right;
    }
    return out;
}

PlaneErrorCause causeOfPlaneError(float exact, std::span<const float> exactBeside, bool isNearCaster)
{
    const auto isOther = [&](float beside) { return (beside >= 0.5f) != (exact >= 0.5f); };
    if (std::any_of(exactBeside.begin(), exactBeside.end(), isOther)) return PlaneErrorCause::NearEdge;
    return exact < 0.5f && isNearCaster ? PlaneErrorCause::NearCaster : PlaneErrorCause::Unexplained;
}

void PlaneErrorCauses::add(PlaneErrorCause cause)
{
    nearEdge += cause == PlaneErrorCause::NearEdge;
    nearCaster += cause == PlaneErrorCause::NearCaster;
    unexplained += cause == PlaneErrorCause::Unexplained;
}

} // namespace lixel
