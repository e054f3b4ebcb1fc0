// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/map_search.h"

#include "lixel/base/fixed_vector.h"
#include "lixel/plan/fit/hull_map.h"
#include "lixel/plan/fit/simplex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace lixel {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Samples that energies without a closed form are asked of, while searching.
constexpr std::size_t kSome = 640;

// The search's axes: so many ways round, and how far towards the hull's horizon (see AxisPlane).
constexpr int kWays = 16;
constexpr std::array<double, 6> kFar{0.4, 0.9, 1.5, 2.2, 3.0, 4.0};
constexpr double kFarthest = 6.5;

// Of those, asked again by samples, and refined.
constexpr std::size_t kAskedAgain = 12, kRefined = 3;
constexpr int kRefinements = 36;

// Rectangles that are asked again by samples.
constexpr std::size_t kSidesAskedAgain = 2;

// All axes before which the hull lies, (a, b, 1), as a plane without borders: a point's direction is that of (a, b), its length
// -log(1 - t) with (a, b) the t-th part of the way to where the hull meets the horizon.
class AxisPlane
{
public:
    explicit AxisPlane(std::span<const Vec3d> corners) : corners_(corners) {}

    Vec3d axisAt(Vec2d p) const
    {
        const double far = std::min(length(p), kFarthest);
        if (!(far > 0)) return {0, 0, 1};
        const Vec2d way = (1 / length(p)) * p;
        double most = 0;
        for (const Vec3d& r : corners_) most = std::max(most, -(way.x * r.x + way.y * r.y) / r.z);
        if (!(most > 0)) return {0, 0, 1};
        const double t = -std::expm1(-far) / most;
        return {t * way.x, t * way.y, 1};
    }

private:
    std::span<const Vec3d> corners_;
};

struct Chosen
{
    HullMaps::Sides sides;
    bool isTurned = false;
    double energy = kInfinite;
};

// Energies of rectangles around the hull for one axis after another.
class Asker
{
public:
    explicit Asker(const MapQuestion& question)
        : question_(question), hull_(question.corners, question.aspect, question.scratch.image)
    {
        if (question.metric == LixelMetric::Area) cubes_.emplace(question.rays);
        if (question.metric == LixelMetric::L2) squares_ = SquaresForm::ofL2(question.rays);
        if (!isClosed()) question.scratch.some.assignSome(question.rays, kSome);
    }

    bool isClosed() const { return question_.metric == LixelMetric::L2 || question_.metric == LixelMetric::Area; }

    // Closed forms of other metrics hold near a map.
    void goNear(const PlaneWarp& map)
    {
        if (!isClosed())
            squares_ = SquaresForm::near(question_.metric, question_.scratch.some, map, question_.scratch.values);
    }

    // By closed forms.
    double estimate(Vec3d w)
    {
        double least = kInfinite;
        forSides(w, [&](const Chosen& chosen) { least = std::min(least, chosen.energy); });
        return least;
    }

    // And by samples, where closed forms are not enough.
    FoundMap best(Vec3d w)
    {
        FixedVector<Chosen, kSidesAskedAgain + 1> few;
        const std::size_t wanted = isClosed() ? 1 : kSidesAskedAgain;
        forSides(w, [&](const Chosen& chosen) {
            if (few.size() == wanted && !(chosen.energy < few.back().energy)) return;
            few.push_back(chosen);
            for (std::size_t i = few.size() - 1; i > 0 && few[i].energy < few[i - 1].energy; --i)
                std::swap(few[i], few[i - 1]);
            if (few.size() > wanted) few.pop_back();
        });
        FoundMap out{{}, kInfinite};
        for (const Chosen& chosen : few) {
            const PlaneWarp map = hull_.rows(chosen.sides, chosen.isTurned);
            const double energy =
                isClosed() ? chosen.energy : lixelEnergy(question_.metric, question_.scratch.some, map);
            if (energy < out.energy) out = {map, energy};
        }
        return out;
    }

    double ofAll(const PlaneWarp& map) const { return lixelEnergy(question_.metric, question_.rays, map); }

private:
    template <typename Take>
    void forSides(Vec3d w, const Take& take)
    {
        if (!hull_.lookAlong(w)) return;
        if (squares_) squaresHere_ = squares_->at(hull_.axis());
        if (cubes_) cubesHere_ = cubes_->at(hull_.axis());
        for (std::size_t i = 0; i < hull_.sideCount(); ++i) {
            const HullMaps::Sides upright = hull_.sides(i);
            takeBothWays(upright, take);
            if (question_.hasShear) takeBothWays(hull_.sheared(upright), take);
        }
    }

    template <typename Take>
    void takeBothWays(const HullMaps::Sides& sides, const Take& take)
    {
        take(Chosen{sides, false, estimateOf(sides, false)});
        if (!hull_.isSquare()) take(Chosen{sides, true, estimateOf(sides, true)});
    }

    // For the axis that the hull is looked at along.
    double estimateOf(const HullMaps::Sides& sides, bool isTurned) const
    {
        const HullMaps::Steps steps = hull_.steps(sides, isTurned);
        if (cubes_) return cubesHere_ * length(cross(steps.alongX, steps.alongY));
        const auto& q = squaresHere_;
        const auto of = [&](Vec3d b) {
            return b.x * (q[0] * b.x + 2 * (q[1] * b.y + q[2] * b.z)) + b.y * (q[3] * b.y + 2 * q[4] * b.z) +
                   q[5] * b.z * b.z;
        };
        return of(steps.alongX) + of(steps.alongY);
    }

    const MapQuestion& question_;
    HullMaps hull_;
    std::optional<SquaresForm> squares_;
    std::optional<CubesForm> cubes_;
    std::array<double, 6> squaresHere_{};
    double cubesHere_ = 0;
};

// The least few of many, in order.
template <std::size_t kMost>
void keepLeast(FixedVector<PlaneValue, kMost>& kept, const PlaneValue& place)
{
    if (kept.size() == kMost) {
        if (!(place.energy < kept.back().energy)) return;
        kept.pop_back();
    }
    kept.push_back(place);
    for (std::size_t i = kept.size() - 1; i > 0 && kept[i].energy < kept[i - 1].energy; --i)
        std::swap(kept[i], kept[i - 1]);
}

// By area; of rectangles around one triangle of corners, which are equally large, the one with the smaller perimeter.
bool isLess(const HullMaps::Sides& a, const HullMaps::Sides& b)
{
    constexpr double kEqual = 1e-9;
    if (std::abs(a.area() - b.area()) > kEqual * b.area()) return a.area() < b.area();
    return a.half.x + a.half.y < (1 - kEqual) * (b.half.x + b.half.y);
}

Vec3d turned(Vec3d v, Vec3d about, double angle) { return std::cos(angle) * v + std::sin(angle) * cross(about, v); }

} // namespace

FoundMap leastAreaMap(const MapQuestion& question, Vec3d w)
{
    HullMaps hull(question.corners, question.aspect, question.scratch.image);
    if (!hull.lookAlong(w)) return {{}, kInfinite};
    HullMaps::Sides least = hull.sides(0);
    for (std::size_t i = 1; i + 1 < hull.sideCount(); ++i)
        if (const HullMaps::Sides sides = hull.sides(i); isLess(sides, least)) least = sides;
    if (question.hasShear) least = hull.sheared(least);
    const bool isTurned = (least.half.x < least.half.y) != (question.aspect < 1) && !hull.isSquare();
    const PlaneWarp map = hull.rows(least, isTurned);
    return {map, lixelEnergy(question.metric, question.rays, map)};
}

FoundMap descend(const MapQuestion& question, Vec3d startW, const Descent& descent)
{
    FoundMap best = leastAreaMap(question, startW), now = best;
    for (int i = 0; i < descent.iterations && now.energy < kInfinite; ++i) {
        const Vec3d w = now.map.w, slope = lixelEnergyChange(question.metric, question.rays, now.map).withW;
        const Vec3d down = normalized(dot(slope, w) * w - slope); // w is a unit vector
        if (!(dot(down, down) > 0)) break;
        FoundMap next{{}, kInfinite};
        for (const double degrees : descent.angles) {
            const Vec3d candidate = turned(w, cross(w, down), degrees * std::numbers::pi / 180);
            const FoundMap found = leastAreaMap(question, candidate);
            if (found.energy < next.energy) next = found;
        }
        now = next;
        if (now.energy < best.energy) best = now;
    }
    return best;
}

FoundMap searchWidely(const MapQuestion& question)
{
    Asker asker(question);
    const AxisPlane axes(question.corners);
    const FoundMap straight = leastAreaMap(question, {0, 0, 1});
    if (!(straight.energy < kInfinite)) return straight;
    asker.goNear(straight.map);

    FixedVector<PlaneValue, kAskedAgain> promising;
    keepLeast(promising, {{0, 0}, asker.estimate({0, 0, 1})});
    for (int way = 0; way < kWays; ++way)
        for (std::size_t far = 0; far < kFar.size(); ++far) {
            const double angle = 2 * std::numbers::pi * (way + 0.5 * double(far % 2)) / kWays;
            const Vec2d p = kFar[far] * Vec2d{std::cos(angle), std::sin(angle)};
            keepLeast(promising, {p, asker.estimate(axes.axisAt(p))});
        }

    const auto energyAt = [&](Vec2d p) { return asker.best(axes.axisAt(p)).energy; };
    FixedVector<PlaneValue, kRefined> few;
    for (const PlaneValue& place : promising) keepLeast(few, {place.p, energyAt(place.p)});

    FoundMap best = straight;
    for (const PlaneValue& place : few) {
        asker.goNear(asker.best(axes.axisAt(place.p)).map);
        const PlaneValue found = leastBySimplex({place.p, energyAt(place.p)}, 0.3, kRefinements, energyAt);
        const FoundMap map = asker.best(axes.axisAt(found.p));
        if (!(map.energy < kInfinite)) continue;
        const double energy = asker.ofAll(map.map);
        if (energy < best.energy) best = {map.map, energy};
    }
    return best;
}

} // namespace lixel
