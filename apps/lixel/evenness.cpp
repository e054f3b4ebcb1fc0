// SPDX-License-Identifier: MIT
#include "evenness.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace lixel::app {
namespace {

// The samples of each lixel of a region.
struct CountedRegion
{
    const PlannedRegion& region;
    LightImage image;
    std::vector<std::uint32_t> counts;

    explicit CountedRegion(const PlannedRegion& of)
        : region(of),
          image(of.projection(), of.rectangle, &of.warp),
          counts(std::size_t(of.rectangle.width()) * std::size_t(of.rectangle.height()), 0)
    {
    }

    bool take(Vec3d p)
    {
        const auto isOutside = [&](const Plane& plane) { return plane.signedDistance(p) < 0; };
        if (std::ranges::any_of(region.halfSpacesLocal, isOutside)) return false;
        const auto lixel = image.lixelAt(p);
        if (!lixel) return false;
        const LixelRectangle& r = region.rectangle;
        const int x = std::clamp(int(lixel->x) - r.x0, 0, r.width() - 1);
        const int y = std::clamp(int(lixel->y) - r.y0, 0, r.height() - 1);
        ++counts[std::size_t(y) * std::size_t(r.width()) + std::size_t(x)];
        return true;
    }
};

} // namespace

Evenness evennessOf(const ShadowPlan& plan, const ViewSamples& samples, const Light& light)
{
    std::vector<CountedRegion> regions;
    for (const PlannedRegion& region : plan.regions) regions.emplace_back(region);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Vec3d p = toDouble(samples.positionLocal[i]);
        if (!isLightFacing(light, samples.originWorld, p, toDouble(samples.normal[i]))) continue;
        std::ranges::any_of(regions, [&](CountedRegion& region) { return region.take(p); });
    }
    double lixels = 0, used = 0, sum = 0, squares = 0;
    for (const CountedRegion& region : regions)
        for (const std::uint32_t count : region.counts) {
            ++lixels;
            used += count > 0;
            sum += count;
            squares += double(count) * count;
        }
    if (!(sum > 0)) return {};
    const double mean = sum / lixels;
    return {used / lixels, std::sqrt(std::max(squares / lixels - mean * mean, 0.0)) / mean};
}

} // namespace lixel::app
