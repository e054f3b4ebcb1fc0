// SPDX-License-Identifier: MIT
#include "lixel/plan/need.h"

#include <algorithm>

namespace lixel {
namespace {

// A lixel that spans the map is not longer in the picture than so many of its diagonals.
constexpr double kMostDiagonals = 8;

// Every step-th of the samples that `wanted` takes, each with the weight of all it stands for.
template <typename Wanted, typename Sample>
void takeEvenly(std::size_t count, std::size_t most, const Wanted& wanted, const Sample& sample,
                std::vector<NeedSample>& out)
{
    std::size_t total = 0;
    for (std::size_t i = 0; i < count; ++i) total += wanted(i);
    if (total == 0) return;
    const std::size_t taken = std::min(total, most);
    std::size_t number = 0, next = 0; // the next one is number next * total / taken + half a step
    for (std::size_t i = 0; i < count && next < taken; ++i) {
        if (!wanted(i)) continue;
        if (number++ < (2 * next + 1) * total / (2 * taken)) continue;
        NeedSample chosen = sample(i);
        chosen.weight *= double(total) / double(taken);
        out.push_back(chosen);
        ++next;
    }
}

// How a surface lies in an image: what its unit tangents are there.
struct PlaneImage
{
    Vec2d first, second;

    PlaneImage(const LightProjection& image, Vec3d pointLocal, Vec3d t1, Vec3d t2)
    {
        const Vec3d a = image.ndcAlong(pointLocal, t1), b = image.ndcAlong(pointLocal, t2);
        first = {a.x, a.y}, second = {b.x, b.y};
    }
};

bool hasBitsOf(const NeedSource& source)
{
    return source.observed && !source.observed->atBoundary.empty() && source.lightNumber < kObservedLights;
}

// An observation's samples as this frame has them.
class ObservedFrom
{
public:
    ObservedFrom(const NeedSource& source, const Light& light, Vec3d originWorld)
        : cells_(source.observed->samples),
          light_(light),
          originWorld_(originWorld),
          toLocal_(cells_.originWorld - originWorld),
          isOfEarlier_(source.observed->ageFrames > 0 && source.view)
    {
        if (isOfEarlier_) clip_ = clipFromLocal(*source.view, originWorld);
    }

    Vec3d at(std::size_t i) const { return toDouble(cells_.positionLocal[i]) + toLocal_; }
    Vec3d normal(std::size_t i) const { return toDouble(cells_.normal[i]); }
    bool isInView(std::size_t i) const
    {
        if (!isOfEarlier_) return true;
        const Vec4d c = clip_ * point(at(i));
        return c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w;
    }
    bool isFacing(std::size_t i) const { return isInView(i) && isLightFacing(light_, originWorld_, at(i), normal(i)); }

private:
    const ViewSamples& cells_;
    const Light& light_;
    Vec3d originWorld_, toLocal_;
    bool isOfEarlier_;
    Mat4d clip_;
};

} // namespace

void gatherNeedSamples(const NeedSource& source, const Light& light, Vec3d originWorld, BoundaryDirections& directions,
                       std::vector<NeedSample>& samples, const NeedSampling& sampling)
{
    samples.clear();
    const Observation* observed = source.observed;
    if (!hasBitsOf(source)) {
        const auto any = [](std::size_t) { return true; };
        const auto seen = [&](std::size_t i) { return NeedSample{source.seenLocal[i], source.seenNormal[i]}; };
        takeEvenly(source.seenLocal.size(), sampling.mostAtBoundaries + sampling.mostOthers, any, seen, samples);
        return;
    }
    const ObservedFrom cells{source, light, originWorld};
    const std::uint32_t bit = std::uint32_t{1} << source.lightNumber;
    directions.observe(*observed, bit);
    const bool skipsJumps = sampling.skipsDepthJumps && !observed->samples.atDepthJump.empty();
    const auto isTaken = [&](std::size_t i) {
        return !(skipsJumps && observed->samples.atDepthJump[i]) && cells.isInView(i);
    };
    const auto isAtBoundary = [&](std::size_t i) { return (observed->atBoundary[i] & bit) != 0; };
    const auto sample = [&](std::size_t i, double part, Vec2d across) {
        return NeedSample{cells.at(i), cells.normal(i), part * double(observed->samples.weightOf(i)), across};
    };
    takeEvenly(
        observed->samples.size(), sampling.mostAtBoundaries,
        [&](std::size_t i) { return isAtBoundary(i) && isTaken(i); },
        [&](std::size_t i) { return sample(i, 1, directions.acrossAt(i)); }, samples);
    if (!(sampling.awayFromBoundaries > 0)) return;
    takeEvenly(
        observed->samples.size(), sampling.mostOthers,
        [&](std::size_t i) { return !isAtBoundary(i) && cells.isFacing(i); },
        [&](std::size_t i) { return sample(i, sampling.awayFromBoundaries, {}); }, samples);
}

void gatherShadows(const NeedSource& source, const Light& light, Vec3d originWorld, std::vector<Vec3d>& shadowsLocal)
{
    shadowsLocal.clear();
    if (!hasBitsOf(source)) return;
    const ObservedFrom cells{source, light, originWorld};
    const std::uint32_t bit = std::uint32_t{1} << source.lightNumber;
    for (std::size_t i = 0; i < source.observed->samples.size(); ++i) {
        const bool isInShadow = !(source.observed->lit[i] & bit) || (source.observed->atBoundary[i] & bit);
        if (isInShadow && cells.isFacing(i)) shadowsLocal.push_back(cells.at(i));
    }
}

NeedPredictor::NeedPredictor(const View& view, Vec3d originWorld)
    : pixelsFromLocal_(clipFromLocal(view, originWorld)), most_(kMostDiagonals * std::hypot(view.width, view.height))
{
    pixelsFromLocal_.setRow(0, 0.5 * view.width * pixelsFromLocal_.row(0));
    pixelsFromLocal_.setRow(1, 0.5 * view.height * pixelsFromLocal_.row(1));
}

Need NeedPredictor::of(const Fit& fit, const NeedSample& sample) const
{
    const Vec3d t1 = anyPerpendicular(sample.normal), t2 = cross(sample.normal, t1);
    const PlaneImage picture(pixelsFromLocal_, sample.pointLocal, t1, t2),
        map(fit.projection(), sample.pointLocal, t1, t2);
    // A lixel of a map of one: its square has side 2. Its sides on the surface, along t1 and t2.
    const double area = cross(map.first, map.second);
    if (!(std::abs(area) > 0)) return {sample.weight * most_, sample.weight * most_};
    const Vec2d x{2 * map.second.y / area, -2 * map.first.y / area},
        y{-2 * map.second.x / area, 2 * map.first.x / area};
    const auto capped = [&](double width) { return sample.weight * std::min(width, most_); };
    const double size = std::sqrt(0.5 * (dot(picture.first, picture.first) + dot(picture.second, picture.second)));
    const double width = std::abs(cross(picture.first, picture.second)) / size; // of the surface's unit, across an edge
    return {capped(width * length(x)), capped(width * length(y))};
}

} // namespace lixel
