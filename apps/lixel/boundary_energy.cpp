// SPDX-License-Identifier: MIT
#include "boundary_energy.h"

#include <algorithm>
#include <cmath>

namespace lixel::app {
namespace {

bool holds(const PlannedRegion& region, Vec3d pointLocal)
{
    const auto isOutside = [&](const Plane& plane) { return plane.signedDistance(pointLocal) < 0; };
    if (std::ranges::any_of(region.halfSpacesLocal, isOutside)) return false;
    const Vec4d c = region.lightClipFromLocal * point(pointLocal);
    return c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && c.z <= c.w;
}

// Coordinates that count lixels from the middle of the map.
Mat4d lixelsFromLocal(const PlannedRegion& region)
{
    Mat4d out = region.lightClipFromLocal;
    out.setRow(0, 0.5 * region.rectangle.width() * out.row(0));
    out.setRow(1, 0.5 * region.rectangle.height() * out.row(1));
    return out;
}

} // namespace

BoundaryEnergy::BoundaryEnergy(const View& view, Vec3d originWorld, const ShadowPlan& plan,
                               std::span<const NeedSample> samples)
{
    std::vector<std::vector<NeedSample>> served(plan.regions.size());
    for (const NeedSample& sample : samples) {
        const auto found = std::ranges::find_if(
            plan.regions, [&](const PlannedRegion& region) { return holds(region, sample.pointLocal); });
        if (found == plan.regions.end()) ++unserved_;
        else served[std::size_t(found - plan.regions.begin())].push_back(sample);
    }
    for (std::size_t i = 0; i < served.size(); ++i) {
        Region region;
        region.rays.assign(view, originWorld, lixelsFromLocal(plan.regions[i]), served[i]);
        if (region.rays.isEmpty()) continue;
        for (const NeedSample& sample : served[i]) region.weight += sample.weight;
        regions_.push_back(std::move(region));
    }
}

std::optional<double> BoundaryEnergy::mean(LixelMetric metric) const
{
    double sum = 0, weight = 0;
    for (const Region& region : regions_) {
        sum += region.weight * lixelEnergy(metric, region.rays, PlaneWarp{});
        weight += region.weight;
    }
    return weight > 0 ? std::optional(sum / weight) : std::nullopt;
}

} // namespace lixel::app
