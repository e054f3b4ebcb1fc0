// SPDX-License-Identifier: MIT
#include "lixel/plan/light_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>

// planes(auto): which of the planes that are seen, have maps of their own.
namespace lixel {
namespace {

// A region is added when it lowers the predicted error to this part at least.
constexpr double kGainOfRegion = 0.95;

// So many of the heaviest planes are tried.
constexpr std::size_t kMostTried = 4;

// Samples away from boundaries tell where planes are, not where they matter.
constexpr float kAwayFromBoundaries = 0.05f;

} // namespace

// In the observation, where there is one, samples at boundaries first.
void LightPlanner::lookForPlanes(std::vector<FoundPlane>& found)
{
    std::vector<Vec3d>&points = scratch_.planePoints, &normals = scratch_.planeNormals;
    std::vector<float>& weights = scratch_.planeWeights;
    points.clear(), normals.clear(), weights.clear();
    PlaneSearch search;
    if (const Observation* observed = input_.observed;
        observed && number_ < kObservedLights && !observed->lit.empty()) {
        const ViewSamples& cells = observed->samples;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const Vec3d p = toDouble(cells.positionLocal[i]) + (cells.originWorld - input_.originWorld);
            const Vec3d n = toDouble(cells.normal[i]);
            if (!isLightFacing(fitInput_.light, input_.originWorld, p, n)) continue;
            points.push_back(p), normals.push_back(n);
            weights.push_back((observed->atBoundary[i] >> number_) & 1u ? 1.0f : kAwayFromBoundaries);
        }
        search.pointsLocal = points, search.normals = normals, search.weights = weights;
    } else {
        search.pointsLocal = scratch_.seenLocal, search.normals = scratch_.seenNormal;
    }
    search.pixelSize = pixelSizeLocal(input_.view, input_.originWorld);
    scratch_.earlierPlanes.clear();
    if (number_ < input_.before.size())
        for (const RememberedPlane& plane : input_.before[number_].planes)
            scratch_.earlierPlanes.push_back(plane.planeLocal);
    search.earlierLocal = scratch_.earlierPlanes;
    FoundPlanes planes;
    findPlanes(search, scratch_.planes, planes);
    found.assign(planes.begin(), planes.end());
}

// One after the other the plane that lowers the predicted error most, as long as one does so by enough. Trials see the few samples
// that predictions ask; the plan itself is then made from all.
InterestPlanes LightPlanner::planesThatPay(std::span<const FoundPlane> found, Twist twist)
{
    scratch_.needLocal.clear();
    for (const NeedSample& sample : scratch_.need) scratch_.needLocal.push_back(sample.pointLocal);
    triedLocal_ = scratch_.needLocal;

    InterestPlanes chosen;
    tryPlanes(chosen, twist, scratch_.leftOut);
    double least = predictedError();
    while (chosen.size() < chosen.capacity()) {
        double best = least, bestWeighed = least;
        std::optional<InterestPlanes> better;
        for (std::size_t i = 0; i < std::min(found.size(), kMostTried); ++i) {
            const auto isThis = [&](const InterestPlane& p) { return p.number == int(i); };
            if (std::any_of(chosen.begin(), chosen.end(), isThis)) continue;
            InterestPlanes with = chosen;
            with.push_back({found[i].planeLocal, {}, int(i)});
            if (tryPlanes(with, twist, scratch_.leftOut)) continue;
            const double error = predictedError(),
                         weighed = hadRegion(found[i].planeLocal) ? error : error / kGainOfRegion;
            if (weighed < bestWeighed) best = error, bestWeighed = weighed, better = with;
        }
        if (!better) break;
        chosen = *better;
        least = best;
    }
    triedLocal_.reset();
    keepThoseThatPay(chosen, twist);
    return chosen;
}

// Maps of all samples are larger than those of the few that were tried with. From the last one on, planes that gain less by that are
// given up.
void LightPlanner::keepThoseThatPay(InterestPlanes& chosen, Twist twist)
{
    const auto errorOf = [&](const InterestPlanes& planes) {
        const bool isRefused = tryPlanes(planes, twist, scratch_.leftOut).has_value();
        return isRefused ? std::numeric_limits<double>::infinity() : predictedError();
    };
    double error = chosen.empty() ? 0 : errorOf(chosen);
    while (!chosen.empty()) {
        const InterestPlane last = chosen.back();
        InterestPlanes fewer = chosen;
        fewer.pop_back();
        const double without = errorOf(fewer);
        if (error < without * (hadRegion(last.planeLocal) ? 1 : kGainOfRegion)) return;
        chosen = fewer, error = without;
    }
}

// In the last frame: such a plane stays without a gain, so that planes do not come and go.
bool LightPlanner::hadRegion(const Plane& planeLocal) const
{
    if (number_ >= input_.before.size()) return false;
    const std::vector<RememberedPlane>& before = input_.before[number_].planes;
    return std::any_of(before.begin(), before.end(), [&](const RememberedPlane& one) {
        return one.hadRegion && one.planeLocal.normal == planeLocal.normal &&
               one.planeLocal.offset == planeLocal.offset;
    });
}

// Of the candidates at the best shares and aspects, for one lixel in all.
double LightPlanner::predictedError()
{
    if (candidates_.empty()) return std::numeric_limits<double>::infinity();
    findNeeds();
    double sum = 0;
    for (const Candidate& candidate : candidates_) sum += std::cbrt(candidate.need.best() * candidate.need.best());
    return sum * std::sqrt(sum);
}

} // namespace lixel
