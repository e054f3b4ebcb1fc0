// SPDX-License-Identifier: MIT
#include "lixel/plan/warp/importance.h"

#include "lixel/base/assert.h"
#include "lixel/shared/importance.h"
#include "lixel/shared/observe.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lixel {
namespace {

constexpr std::uint32_t kNoSample = 0xffffffffu;

// Pixels from a boundary within which samples count as near it.
constexpr double kNearBoundary = 4;

shared::vec3 toShared(Vec3f v) { return {v.x, v.y, v.z}; }

// The picture in cells of about one sample each: its pixels, or where samples stand for many pixels, squares of as many.
class SampleGrid
{
public:
    explicit SampleGrid(const ViewSamples& samples)
        : samples_(samples),
          side_(samples.size() == 0 ? 1 : std::max(1, int(std::lround(std::sqrt(samples.weightOf(0))))))
    {
    }

    int width() const { return std::max(1, (samples_.width + side_ - 1) / side_); }
    int height() const { return std::max(1, (samples_.height + side_ - 1) / side_); }
    std::size_t cellOf(std::size_t sample) const
    {
        const int x = std::clamp(int(samples_.pixel[sample].x) / side_, 0, width() - 1);
        const int y = std::clamp(int(samples_.pixel[sample].y) / side_, 0, height() - 1);
        return std::size_t(y) * std::size_t(width()) + std::size_t(x);
    }

private:
    const ViewSamples& samples_;
    int side_;
};

// Whether one surface goes on without an edge from one sample to the next.
bool isSmooth(const ViewSamples& samples, std::size_t a, std::size_t b)
{
    const shared::vec3 pa = toShared(samples.positionLocal[a]), pb = toShared(samples.positionLocal[b]);
    const shared::vec3 na = toShared(samples.normal[a]), nb = toShared(samples.normal[b]);
    return shared::dot(na, nb) >= shared::LX_EDGE_COSINE && !shared::lxIsDepthJump(pa, na, pb, nb);
}

// Marks samples with a neighbour, right or left, above or below, across an edge, or where nothing is seen.
void markEdges(const ViewSamples& samples, ImportanceScratch& scratch)
{
    const SampleGrid grid(samples);
    const auto width = std::size_t(grid.width()), height = std::size_t(grid.height());
    std::vector<std::uint32_t>& of = scratch.sampleOfPixel;
    of.assign(width * height, kNoSample);
    for (std::size_t i = samples.size(); i-- > 0;) of[grid.cellOf(i)] = std::uint32_t(i);
    scratch.atEdge.assign(width * height, 0);
    const auto markPair = [&](std::size_t a, std::size_t b) {
        if (of[a] == kNoSample || of[b] == kNoSample || !isSmooth(samples, of[a], of[b]))
            scratch.atEdge[a] = scratch.atEdge[b] = 1;
    };
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t at = y * width + x;
            if (x + 1 < width) markPair(at, at + 1);
            if (y + 1 < height) markPair(at, at + width);
        }
}

// The cells of the observation that are near a boundary of a light.
void markBoundaries(const Observation& observed, std::uint32_t bit, std::vector<std::uint8_t>& near)
{
    const ObservationGrid grid = observed.grid;
    near.assign(std::size_t(grid.width) * std::size_t(grid.height), 0);
    const auto reachOf = [](int cells, int pixels) {
        return std::max(1, int(std::lround(kNearBoundary * cells / pixels)));
    };
    const int reachX = reachOf(grid.width, observed.view.width), reachY = reachOf(grid.height, observed.view.height);
    for (std::size_t i = 0; i < observed.samples.size(); ++i) {
        if (!(observed.atBoundary[i] & bit)) continue;
        const int x = int(observed.samples.pixel[i].x * float(grid.width) / float(observed.view.width));
        const int y = int(observed.samples.pixel[i].y * float(grid.height) / float(observed.view.height));
        for (int v = std::max(0, y - reachY); v <= std::min(grid.height - 1, y + reachY); ++v)
            for (int u = std::max(0, x - reachX); u <= std::min(grid.width - 1, x + reachX); ++u)
                near[std::size_t(v) * std::size_t(grid.width) + std::size_t(u)] = 1;
    }
}

// Weights of the samples of one list.
class Weigher
{
public:
    Weigher(const ImportanceSource& source, const Importance& importance, const ViewSamples& samples, bool isOfLight,
            ImportanceScratch& scratch)
        : source_(source),
          importance_(importance),
          samples_(samples),
          scratch_(scratch),
          grid_(samples),
          isOfLight_(isOfLight)
    {
        const Vec4d eye = eyeLocal(source.view, source.originWorld);
        eye_ = toFloat(xyz(eye));
        isEyeAway_ = eye.w == 0;
        if (importance.has(kDistanceWeight)) findNearest();
        if (importance.has(kEdgesWeight) || importance.has(kShadowEdgesWeight)) markEdges(samples, scratch);
        if (importance.has(kBoundariesWeight) && source.observed && !source.observed->atBoundary.empty() &&
            source.lightNumber < kObservedLights) {
            markBoundaries(*source.observed, std::uint32_t{1} << source.lightNumber, scratch.nearBoundary);
            observedFromLocal_ = clipFromLocal(source.observed->view, source.originWorld);
            knowsBoundaries_ = true;
        }
    }

    float weightOf(std::size_t i) const
    {
        float weight = samples_.weightOf(i), greatest = 0;
        bool hasGreatest = false;
        for (const SampleWeight one :
             {kDistanceWeight, kNormalWeight, kEdgesWeight, kBoundariesWeight, kShadowEdgesWeight}) {
            if (!importance_.has(one) || !isKnown(one)) continue;
            hasGreatest |= (importance_.greatestOf & one) != 0;
            const float value = weightOf(one, i);
            if (importance_.factors & one) weight *= value;
            if (importance_.greatestOf & one) greatest = std::max(greatest, value);
        }
        return hasGreatest ? weight * greatest : weight;
    }

private:
    // Edges are the view's or the light's; boundaries were observed, or not.
    bool isKnown(SampleWeight weight) const
    {
        if (weight == kEdgesWeight) return !isOfLight_;
        if (weight == kShadowEdgesWeight) return isOfLight_;
        return weight != kBoundariesWeight || knowsBoundaries_;
    }

    float weightOf(SampleWeight weight, std::size_t i) const
    {
        switch (weight) {
        case kDistanceWeight: return shared::lxDistanceWeight(nearest2_, distance2(i));
        case kNormalWeight: return normalWeight(i);
        case kEdgesWeight:
        case kShadowEdgesWeight: return awayUnless(isAtEdge(i), shared::LX_AWAY_FROM_EDGES);
        case kBoundariesWeight: return awayUnless(isNearBoundary(i), shared::LX_AWAY_FROM_BOUNDARIES);
        }
        return 1;
    }

    static float awayUnless(bool isNear, float away) { return isNear ? 1 : away; }

    // From an eye infinitely far away all are as near.
    float distance2(std::size_t i) const
    {
        if (isEyeAway_) return 1;
        const shared::vec3 to = toShared(samples_.positionLocal[i]) - toShared(eye_);
        return shared::dot(to, to);
    }

    void findNearest()
    {
        float nearest = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < samples_.size(); ++i) nearest = std::min(nearest, distance2(i));
        nearest2_ = nearest;
    }

    float normalWeight(std::size_t i) const
    {
        const Vec3d p = toDouble(samples_.positionLocal[i]), n = toDouble(samples_.normal[i]);
        const Vec3d eye = normalized(towardsEye(source_.view, source_.originWorld, p));
        const Vec3d light = towardsLight(source_.light, source_.originWorld, p);
        return shared::lxNormalWeight(float(std::abs(dot(n, eye))), float(dot(n, light)));
    }

    bool isAtEdge(std::size_t i) const { return scratch_.atEdge[grid_.cellOf(i)] != 0; }

    // Where the earlier picture did not see, nothing is known, and nothing is missed.
    bool isNearBoundary(std::size_t i) const
    {
        const Vec4d c = observedFromLocal_ * point(toDouble(samples_.positionLocal[i]));
        if (!(c.w > 0) || std::abs(c.x) > c.w || std::abs(c.y) > c.w) return true;
        const ObservationGrid grid = source_.observed->grid;
        const int x = std::min(int((0.5 + 0.5 * c.x / c.w) * grid.width), grid.width - 1);
        const int y = std::min(int((0.5 + 0.5 * c.y / c.w) * grid.height), grid.height - 1);
        return scratch_.nearBoundary[std::size_t(y) * std::size_t(grid.width) + std::size_t(x)] != 0;
    }

    const ImportanceSource& source_;
    const Importance& importance_;
    const ViewSamples& samples_;
    const ImportanceScratch& scratch_;
    SampleGrid grid_;
    bool isOfLight_, isEyeAway_ = false, knowsBoundaries_ = false;
    Vec3f eye_;
    float nearest2_ = 1;
    Mat4d observedFromLocal_;
};

// What the light sees counts where the view might see it.
bool isInView(const Mat4d& viewClipFromLocal, Vec3d p)
{
    const Vec4d c = viewClipFromLocal * point(p);
    return c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && c.z <= c.w;
}

void weighList(const ImportanceSource& source, const Importance& importance, const ViewSamples& samples, bool isOfLight,
               ImportanceScratch& scratch, std::vector<WeighedSample>& out)
{
    const Weigher weigher(source, importance, samples, isOfLight, scratch);
    const Mat4d viewClipFromLocal = clipFromLocal(source.view, source.originWorld);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Vec3d p = toDouble(samples.positionLocal[i]), n = toDouble(samples.normal[i]);
        if (!isLightFacing(source.light, source.originWorld, p, n)) continue;
        if (isOfLight && !isInView(viewClipFromLocal, p)) continue;
        out.push_back({samples.positionLocal[i], std::uint32_t(shared::lxImportanceUnits(weigher.weightOf(i)))});
    }
}

} // namespace

void weighSamples(const ImportanceSource& source, const WarpOptions& options, ImportanceScratch& scratch,
                  std::vector<WeighedSample>& out)
{
    out.clear();
    if (options.analysis != Analysis::Forward && source.seen)
        weighList(source, options.importance, *source.seen, false, scratch, out);
    if (options.analysis == Analysis::Backward) return;
    for (const ViewSamples& picture : source.seenByLight)
        weighList(source, options.importance, picture, true, scratch, out);
}

void countSamples(std::span<const PlacedSample> samples, int columns, int rows, bool isCounted,
                  std::vector<std::uint32_t>& map)
{
    map.assign(std::size_t(columns) * std::size_t(rows), 0);
    for (const PlacedSample& sample : samples) {
        LX_ASSERT(sample.x >= 0 && sample.x <= 1 && sample.y >= 0 && sample.y <= 1);
        const int x = std::min(int(sample.x * float(columns)), columns - 1);
        const int y = std::min(int(sample.y * float(rows)), rows - 1);
        std::uint32_t& cell = map[std::size_t(y) * std::size_t(columns) + std::size_t(x)];
        cell = isCounted ? cell + sample.units : std::max(cell, sample.units);
    }
}

} // namespace lixel
