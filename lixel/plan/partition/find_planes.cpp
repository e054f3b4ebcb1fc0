// SPDX-License-Identifier: MIT
#include "lixel/plan/partition/find_planes.h"

#include "lixel/base/assert.h"
#include "lixel/base/enclosing_polygon.h"
#include "lixel/base/rectangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

// Normals are counted in cells of directions. The heaviest cell proposes planes: through one of its samples with that sample's
// normal, which is exact where normals are, and through three of its samples, which serves where normals are noisy. The proposal that
// most of the samples around agree with is fitted to them, judged, and takes its samples away; then comes the next cell.
namespace lixel {
namespace {

constexpr std::size_t kMostSamples = 4096;

// Float rounding of positions and of what they were made from, against the largest coordinate.
constexpr double kRounding = 0x1p-22;

// A grid over the cube around the unit sphere, cells 3.5 degrees wide; an odd count has the axes amid cells.
constexpr int kCellsAcross = 33;

// The least cell that is looked at, against the least plane: noise of normals spreads a plane over several cells.
constexpr double kLeastCell = 1.0 / 5;

constexpr int kMostTries = 32;
constexpr std::size_t kMostKept = 16; // until the heaviest are chosen

// Cosine of 0.03 degrees: normals of a cell that are one but for rounding.
constexpr double kOneNormal = 1 - 1e-7;

// Of an earlier plane's samples in a new fit, and of how much more it may miss them, in tolerances.
constexpr double kEarlierCount = 63.0 / 64, kEarlierMiss = 0.125;
constexpr double kEarlierShare = 0.5; // of the least share

// Shares, and normals, that differ by less are equal but for rounding.
constexpr double kEqual = 1e-7;

struct Search
{
    PlaneScratch& scratch;
    double totalWeight = 0;
    FixedVector<FoundPlane, kMostKept> kept = {};
};

// Fractions of golden sections: even at any length, and in step with no row of a picture.
double goldenFraction(std::size_t k, double start = 0)
{
    const double x = start + 0.6180339887498949 * double(k);
    return x - std::floor(x);
}

std::uint16_t cellOf(Vec3d normal)
{
    const auto along = [](double x) { return std::clamp(int((0.5 + 0.5 * x) * kCellsAcross), 0, kCellsAcross - 1); };
    return std::uint16_t((along(normal.z) * kCellsAcross + along(normal.y)) * kCellsAcross + along(normal.x));
}

void prepare(PlaneScratch& scratch)
{
    for (auto* samples : {&scratch.samples, &scratch.group}) samples->clear(), samples->reserve(kMostSamples);
    for (auto* cells : {&scratch.cells, &scratch.cellOfSample}) cells->clear(), cells->reserve(kMostSamples);
    for (auto* points : {&scratch.onPlane, &scratch.hull}) points->clear(), points->reserve(kMostSamples + 1);
    scratch.cellWeights.assign(kCellsAcross * kCellsAcross * kCellsAcross, 0);
}

// One sample of each run of the list, at another place in each. Returns the weight of all.
double takeSamples(const PlaneSearch& search, PlaneScratch& scratch)
{
    const std::size_t count = search.pointsLocal.size(), looked = std::min(count, kMostSamples);
    const double run = double(count) / double(looked);
    double total = 0, farthest = 0;
    for (std::size_t k = 0; k < looked; ++k) {
        const std::size_t i =
            looked == count ? k : std::min(std::size_t((double(k) + goldenFraction(k)) * run), count - 1);
        const Vec3d p = search.pointsLocal[i], normal = search.normals[i];
        const double weight = search.weights.empty() ? 1.0 : double(search.weights[i]);
        if (!(weight > 0) || !isFinite(p) || !(std::abs(dot(normal, normal) - 1) < 0.1)) continue;
        const std::uint16_t cell = cellOf(normal);
        scratch.samples.push_back({p, normal, weight, kFlatWithinPixels * dot(search.pixelSize, point(p))});
        scratch.cellOfSample.push_back(cell);
        if (scratch.cellWeights[cell] == 0) scratch.cells.push_back(cell);
        scratch.cellWeights[cell] += weight;
        farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        total += weight;
    }
    const double rounding = std::max(kRounding * farthest, 1e-300);
    for (PlaneSample& sample : scratch.samples) sample.tolerance = std::max(sample.tolerance, rounding);
    return total;
}

void gatherGroup(PlaneScratch& scratch, Vec3d normal)
{
    scratch.group.clear();
    for (const PlaneSample& sample : scratch.samples)
        if (dot(sample.normal, normal) >= kSimilarNormal) scratch.group.push_back(sample);
}

bool isPlane(const std::optional<JudgedPlane>& judged, double leastWeight)
{
    return judged && judged->count >= kLeastPlaneSamples && judged->weight >= leastWeight && !judged->isSlice();
}

// Planes through samples of a cell, which come first in the group.
struct Proposer
{
    std::span<const PlaneSample> group;
    std::size_t inCell = 0;
    Vec3d meanNormal;
    Plane best = {};
    double bestScore = -1; // weight of those asked in the group that agree

    const PlaneSample& pick(std::size_t k, double start) const
    {
        return group[std::min(std::size_t(goldenFraction(k, start) * double(inCell)), inCell - 1)];
    }
    void propose(const Plane& plane)
    {
        constexpr std::size_t kMostAsked = 128;
        const std::size_t asked = std::min(group.size(), kMostAsked);
        double score = 0;
        for (std::size_t k = 0; k < asked; ++k) {
            const PlaneSample& sample = group[k * group.size() / asked];
            if (std::abs(plane.signedDistance(sample.p)) <= sample.tolerance) score += sample.weight;
        }
        if (score > bestScore) best = plane, bestScore = score;
    }
    void proposeByNormal(std::size_t k)
    {
        const PlaneSample& sample = pick(k, 0.5);
        propose(planeThrough(sample.p, normalized(sample.normal)));
    }
    void proposeByThree(std::size_t k)
    {
        const Vec3d a = pick(k, 0.1).p, b = pick(2 * k, 0.43).p, c = pick(5 * k, 0.77).p;
        const Vec3d normal = normalized(cross(b - a, c - a));
        const double along = dot(normal, meanNormal);
        if (std::abs(along) >= kSimilarNormal) propose(planeThrough(a, along > 0 ? normal : -normal));
    }
};

// What a cell of directions shows; the group is then of its normal.
std::optional<JudgedPlane> planeOfCell(PlaneScratch& scratch, std::uint16_t cell, double leastWeight)
{
    constexpr std::size_t kSingles = 6, kTriples = 16, kRounds = 2;
    Vec3d sum;
    for (std::size_t i = 0; i < scratch.samples.size(); ++i)
        if (scratch.cellOfSample[i] == cell) sum = sum + scratch.samples[i].normal;
    Proposer proposer{scratch.group, 0, normalized(sum)};
    gatherGroup(scratch, proposer.meanNormal);
    proposer.group = scratch.group;
    double weight = 0;
    for (const PlaneSample& sample : scratch.group) weight += sample.weight;
    if (weight < leastWeight || scratch.group.size() < kLeastPlaneSamples) return std::nullopt;
    const auto end = std::partition(scratch.group.begin(), scratch.group.end(),
                                    [&](const PlaneSample& sample) { return cellOf(sample.normal) == cell; });
    proposer.inCell = std::size_t(end - scratch.group.begin());
    if (proposer.inCell == 0) return std::nullopt;

    bool isOneNormal = true;
    for (std::size_t k = 0; k < kSingles; ++k) {
        isOneNormal = isOneNormal && dot(proposer.pick(k, 0.5).normal, proposer.meanNormal) >= kOneNormal;
        proposer.proposeByNormal(k);
    }
    // Three samples may be of different planes, or nearly in line.
    std::optional<JudgedPlane> plane;
    for (std::size_t round = 0; round < kRounds && !isPlane(plane, leastWeight); ++round) {
        proposer.bestScore = round == 0 ? proposer.bestScore : -1;
        for (std::size_t k = 0; !isOneNormal && k < kTriples; ++k) proposer.proposeByThree(round * kTriples + k);
        plane = settlePlane(scratch.group, proposer.best);
        if (isOneNormal) break;
    }
    return plane;
}

// An earlier plane with its own numbers while they are as good as a new fit's, else with new ones.
std::optional<JudgedPlane> planeAsBefore(PlaneScratch& scratch, const Plane& earlier)
{
    gatherGroup(scratch, earlier.normal);
    const std::optional<JudgedPlane> fit = settlePlane(scratch.group, earlier);
    if (!fit) return std::nullopt;
    const JudgedPlane asBefore = judgePlane(scratch.group, earlier);
    const bool isAsGood =
        double(asBefore.count) >= kEarlierCount * double(fit->count) && asBefore.miss <= fit->miss + kEarlierMiss;
    return isAsGood ? asBefore : fit;
}

void outline(PlaneScratch& scratch, FoundPlane& found)
{
    const Plane& plane = found.planeLocal;
    const Vec3d u = anyPerpendicular(plane.normal), v = cross(plane.normal, u);
    std::optional<Vec3d> from; // on the plane, amid the samples
    std::vector<Vec2d>& points = scratch.onPlane;
    points.clear();
    for (const PlaneSample& sample : scratch.group) {
        if (!isOnPlane(sample, plane)) continue;
        if (!from) from = sample.p - plane.signedDistance(sample.p) * plane.normal;
        points.push_back({dot(u, sample.p - *from), dot(v, sample.p - *from)});
    }
    scratch.hull.resize(points.size() + 1);
    const std::size_t corners = convexHull(points, scratch.hull);
    const std::size_t count =
        encloseWithFewerCorners(std::span(scratch.hull).first(corners), found.cornersLocal.capacity());
    for (std::size_t i = 0; i < count; ++i)
        found.cornersLocal.push_back(*from + scratch.hull[i].x * u + scratch.hull[i].y * v);
}

// What is left within a few tolerances of a plane that was taken, too rough for it, is no other plane; what is sharp is one.
bool isLeftOverOf(const FoundPlane& taken, const JudgedPlane& plane, std::span<const PlaneSample> group)
{
    constexpr double kNear = 3; // tolerances
    if (plane.isSharp()) return false;
    std::size_t near = 0;
    for (const PlaneSample& sample : group)
        near += isOnPlane(sample, plane.plane) && isOnPlane(sample, taken.planeLocal, kNear) ? 1 : 0;
    return 2 * near > plane.count;
}

// Removes the plane's samples from the list.
void takeAway(PlaneScratch& scratch, const Plane& plane)
{
    std::size_t left = 0;
    for (std::size_t i = 0; i < scratch.samples.size(); ++i) {
        const PlaneSample sample = scratch.samples[i];
        const std::uint16_t cell = scratch.cellOfSample[i];
        if (isOnPlane(sample, plane)) {
            scratch.cellWeights[cell] -= sample.weight;
            continue;
        }
        scratch.samples[left] = sample;
        scratch.cellOfSample[left++] = cell;
    }
    scratch.samples.resize(left);
    scratch.cellOfSample.resize(left);
}

// Whether the plane of the group is one; then its samples are its own.
bool keep(Search& search, const std::optional<JudgedPlane>& plane, double leastWeight)
{
    if (!isPlane(plane, leastWeight)) return false;
    const bool isLeftOver = std::any_of(search.kept.begin(), search.kept.end(), [&](const FoundPlane& taken) {
        return isLeftOverOf(taken, *plane, search.scratch.group);
    });
    if (!isLeftOver) {
        FoundPlane found{plane->plane, plane->weight / search.totalWeight};
        outline(search.scratch, found);
        search.kept.push_back(found);
    }
    takeAway(search.scratch, plane->plane);
    return true;
}

std::uint16_t heaviestCell(const PlaneScratch& scratch)
{
    return *std::max_element(scratch.cells.begin(), scratch.cells.end(), [&](std::uint16_t a, std::uint16_t b) {
        const double weightA = scratch.cellWeights[a], weightB = scratch.cellWeights[b];
        return weightA < weightB || (weightA == weightB && a > b);
    });
}

// Heavier first; of those that are equal but for rounding, by their numbers.
bool isBefore(const FoundPlane& a, const FoundPlane& b)
{
    const auto key = [](const FoundPlane& found) {
        const auto rounded = [](double x, double step) { return std::round(x / step); };
        const Vec3d n = found.planeLocal.normal;
        return std::array{rounded(found.weight, kEqual), rounded(n.x, kEqual), rounded(n.y, kEqual),
                          rounded(n.z, kEqual), found.planeLocal.offset};
    };
    return key(a) > key(b);
}

} // namespace

Vec4d pixelSizeLocal(const View& view, Vec3d originWorld)
{
    // At a depth, where w is one value, NDC grows with the part of its row that is at right angles to w's.
    const Mat4d clip = clipFromLocal(view, originWorld);
    const Vec4d w = clip.row(3);
    const Vec3d deeper = normalized(xyz(w));
    const auto pixel = [&](int row, int pixels) {
        const Vec3d along = xyz(clip.row(row));
        return 2 / (double(pixels) * length(along - dot(along, deeper) * deeper));
    };
    return std::min(pixel(0, view.width), pixel(1, view.height)) * w;
}

void findPlanes(const PlaneSearch& search, PlaneScratch& scratch, FoundPlanes& found)
{
    LX_ASSERT(search.normals.size() == search.pointsLocal.size());
    LX_ASSERT(search.weights.empty() || search.weights.size() == search.pointsLocal.size());
    found.clear();
    prepare(scratch);
    Search state{scratch, takeSamples(search, scratch)};
    if (scratch.cells.empty()) return;

    const double leastWeight = kLeastPlaneShare * state.totalWeight;
    for (const Plane& earlier : search.earlierLocal) {
        if (state.kept.size() == kMostKept) break;
        keep(state, planeAsBefore(scratch, earlier), kEarlierShare * leastWeight);
    }
    for (int i = 0; i < kMostTries && state.kept.size() < kMostKept; ++i) {
        const std::uint16_t cell = heaviestCell(scratch);
        if (!(scratch.cellWeights[cell] >= kLeastCell * leastWeight)) break;
        if (!keep(state, planeOfCell(scratch, cell, leastWeight), leastWeight)) scratch.cellWeights[cell] = 0;
    }
    std::sort(state.kept.begin(), state.kept.end(), isBefore);
    for (const FoundPlane& plane : state.kept)
        if (found.size() < FoundPlanes::capacity()) found.push_back(plane);
}

} // namespace lixel
