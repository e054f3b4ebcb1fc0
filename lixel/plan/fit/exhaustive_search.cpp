// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/exhaustive_search.h"

#include "lixel/plan/fit/hull_map.h"
#include "lixel/plan/fit/simplex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace lixel {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Some samples tell the best rectangle from those that are worse by this part.
constexpr double kSurelyWorse = 1.05;

class EveryRectangle
{
public:
    EveryRectangle(const MapQuestion& question, std::size_t count)
        : question_(question), hull_(question.corners, question.aspect, question.scratch.image)
    {
        some_.assignSome(question.rays, count);
    }

    // The least energy, and the map that has it.
    FoundMap bySome(Vec3d w)
    {
        findAll(w);
        return found_.empty() ? FoundMap{{}, kInfinite} : *std::min_element(found_.begin(), found_.end(), isLess);
    }
    FoundMap byAll(Vec3d w)
    {
        const double surely = kSurelyWorse * bySome(w).energy;
        FoundMap best{{}, kInfinite};
        for (FoundMap& found : found_) {
            if (!(found.energy <= surely)) continue;
            if (some_.size() < question_.rays.size() || some_.edgeWeight.size() < question_.rays.edgeWeight.size())
                found.energy = lixelEnergy(question_.metric, question_.rays, found.map);
            if (found.energy < best.energy) best = found;
        }
        return best;
    }

private:
    static bool isLess(const FoundMap& a, const FoundMap& b) { return a.energy < b.energy; }

    void findAll(Vec3d w)
    {
        found_.clear();
        if (!hull_.lookAlong(w)) return;
        for (std::size_t i = 0; i < hull_.sideCount(); ++i) {
            const HullMaps::Sides upright = hull_.sides(i);
            for (const bool isTurned : {false, true}) {
                if (isTurned && hull_.isSquare()) break;
                add(upright, isTurned);
                if (question_.hasShear) add(hull_.sheared(upright), isTurned);
            }
        }
    }

    void add(const HullMaps::Sides& sides, bool isTurned)
    {
        const PlaneWarp map = hull_.rows(sides, isTurned);
        found_.push_back({map, lixelEnergy(question_.metric, some_, map)});
    }

    const MapQuestion& question_;
    HullMaps hull_;
    EdgeRays some_;
    std::vector<FoundMap> found_;
};

// Evenly over the hemisphere: zones of equal height, each turned on by the golden section of the circle.
Vec3d axisOf(int i, int count)
{
    const double z = (i + 0.5) / count, angle = 2 * std::numbers::pi * std::numbers::phi * i, r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

} // namespace

FoundMap searchExhaustively(const MapQuestion& question, const Exhaustion& exhaustion)
{
    EveryRectangle every(question, exhaustion.samplesOfAll);
    struct AxisEnergy
    {
        Vec3d w;
        double energy;
    };
    std::vector<AxisEnergy> axes{{{0, 0, 1}, every.bySome({0, 0, 1}).energy}};
    for (int i = 0; i < exhaustion.axes; ++i) {
        const Vec3d w = axisOf(i, exhaustion.axes);
        const double energy = every.bySome(w).energy;
        if (energy < kInfinite) axes.push_back({w, energy});
    }
    const auto count = std::min(exhaustion.refined, axes.size());
    std::partial_sort(axes.begin(), axes.begin() + std::ptrdiff_t(count), axes.end(),
                      [](const AxisEnergy& a, const AxisEnergy& b) { return a.energy < b.energy; });

    // About the distance between axes.
    const double size = std::sqrt(2 * std::numbers::pi / exhaustion.axes);
    FoundMap best{{}, kInfinite};
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d w = axes[i].w, e1 = anyPerpendicular(w), e2 = cross(w, e1);
        const auto at = [&](Vec2d p) { return every.byAll(normalized(w + p.x * e1 + p.y * e2)); };
        const auto energyAt = [&](Vec2d p) { return at(p).energy; };
        const FoundMap found = at(leastBySimplex({{0, 0}, energyAt({0, 0})}, size, exhaustion.refinements, energyAt).p);
        if (found.energy < best.energy) best = found;
    }
    return best;
}

} // namespace lixel
