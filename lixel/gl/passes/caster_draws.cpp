// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/caster_draws.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lixel::gl {
namespace {

// Matrices and clip coordinates are rounded to float on the device, some ten roundings of 6e-8 on sums of these terms.
constexpr double kRounding = 1e-6;

bool isOutside(const Plane& plane, const Box& box)
{
    const auto reach = [](double n, double min, double max) { return n * (n > 0 ? max : min); };
    const auto size = [](double n, double min, double max) {
        return std::abs(n) * std::max(std::abs(min), std::abs(max));
    };
    const Vec3d& n = plane.normal;
    const double farthest = reach(n.x, box.min.x, box.max.x) + reach(n.y, box.min.y, box.max.y) +
                            reach(n.z, box.min.z, box.max.z) + plane.offset;
    const double terms = size(n.x, box.min.x, box.max.x) + size(n.y, box.min.y, box.max.y) +
                         size(n.z, box.min.z, box.max.z) + std::abs(plane.offset);
    return farthest < -kRounding * terms;
}

bool isOutside(std::span<const Plane> volume, const Box& box)
{
    return std::any_of(volume.begin(), volume.end(), [&](const Plane& plane) { return isOutside(plane, box); });
}

} // namespace

void CasterDraws::list(std::span<const CasterRun> runs, std::span<const std::vector<Plane>> volumes,
                       std::uint32_t firstRegion, std::uint32_t among)
{
    LX_ASSERT(volumes.size() <= 32);
    groups_.clear(), commands_.clear(), instances_.clear();
    drawn_ = culled_ = 0;
    if (volumes.size() < 32) among &= (1u << volumes.size()) - 1;
    const auto most = std::uint64_t(std::popcount(among));
    for (const CasterRun& run : runs) {
        std::uint32_t regions = 0;
        for (std::size_t i = 0; i < volumes.size(); ++i)
            if ((among >> i & 1u) != 0 && !isOutside(volumes[i], run.boxLocal)) regions |= 1u << i;
        const auto count = std::uint64_t(std::popcount(regions));
        drawn_ += count * run.triangleCount;
        culled_ += (most - count) * run.triangleCount;
        if (regions) add(run, regions, firstRegion);
    }
}

void CasterDraws::add(const CasterRun& run, std::uint32_t regions, std::uint32_t firstRegion)
{
    const bool isOfLastGroup = !groups_.empty() && groups_.back().maskedRange == run.maskedRange;
    if (isOfLastGroup && regions == lastRegions_) {
        DrawCommand& last = commands_.back();
        if (last.firstIndex + last.indexCount == 3 * run.firstTriangle) {
            last.indexCount += 3 * run.triangleCount;
            return;
        }
    }
    if (!isOfLastGroup) groups_.push_back({run.maskedRange, std::uint32_t(commands_.size()), 0});
    ++groups_.back().count;
    commands_.push_back({3 * run.triangleCount, std::uint32_t(std::popcount(regions)), 3 * run.firstTriangle, 0,
                         std::uint32_t(instances_.size())});
    for (std::uint32_t i = 0; i < 32; ++i)
        if (regions >> i & 1u) instances_.push_back({firstRegion + i, run.firstTriangle});
    lastRegions_ = regions;
}

} // namespace lixel::gl
