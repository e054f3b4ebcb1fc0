// SPDX-License-Identifier: MIT
#include "lixel/judge/score.h"

#include "lixel/base/assert.h"
#include "lixel/base/image.h"

#include <array>
#include <cmath>

namespace lixel {
namespace {

constexpr std::uint32_t kNoSample = 0xffffffffu;

// The first sample of each pixel.
Image<std::uint32_t> firstSamples(const ViewSamples& samples)
{
    Image<std::uint32_t> first(samples.width, samples.height, kNoSample);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const int x = int(std::floor(samples.pixel[i].x)), y = int(std::floor(samples.pixel[i].y));
        if (first.contains(x, y) && first(x, y) == kNoSample) first(x, y) = std::uint32_t(i);
    }
    return first;
}

// Marks every pixel whose centre is within kBandPixels of (x, y), given in pixels with centres at whole numbers.
void markAround(Image<std::uint8_t>& marked, double x, double y)
{
    constexpr int kReach = int(kBandPixels) + 1;
    for (int j = int(std::floor(y)) - kReach; j <= int(std::ceil(y)) + kReach; ++j)
        for (int i = int(std::floor(x)) - kReach; i <= int(std::ceil(x)) + kReach; ++i)
            if (marked.contains(i, j) && (i - x) * (i - x) + (j - y) * (j - y) <= kBandPixels * kBandPixels)
                marked(i, j) = 1;
}

} // namespace

std::vector<Zone> zonesOf(const ViewSamples& samples, const Light& light, std::span<const float> exactVisibility)
{
    LX_ASSERT(exactVisibility.size() == samples.size());
    std::vector<Zone> zones(samples.size(), Zone::FacingAway);
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (isLightFacing(light, samples.originWorld, toDouble(samples.positionLocal[i]), toDouble(samples.normal[i])))
            zones[i] = Zone::Interior;

    const Image<std::uint32_t> first = firstSamples(samples);
    Image<std::uint8_t> nearBoundary(samples.width, samples.height, 0), nearFacingAway = nearBoundary;
    for (int y = 0; y < samples.height; ++y)
        for (int x = 0; x < samples.width; ++x) {
            const std::uint32_t here = first(x, y);
            if (here == kNoSample) continue;
            if (zones[here] == Zone::FacingAway) {
                markAround(nearFacingAway, x, y);
                continue;
            }
            for (const auto& [dx, dy] : {std::array{1, 0}, std::array{0, 1}}) {
                const std::uint32_t there = first.contains(x + dx, y + dy) ? first(x + dx, y + dy) : kNoSample;
                if (there == kNoSample || zones[there] == Zone::FacingAway) continue;
                if ((exactVisibility[here] >= 0.5f) != (exactVisibility[there] >= 0.5f))
                    markAround(nearBoundary, x + 0.5 * dx, y + 0.5 * dy);
            }
        }

    for (std::size_t i = 0; i < samples.size(); ++i) {
        const int x = int(std::floor(samples.pixel[i].x)), y = int(std::floor(samples.pixel[i].y));
        if (zones[i] == Zone::FacingAway || !first.contains(x, y)) continue;
        if (nearBoundary(x, y)) zones[i] = Zone::EdgeBand;
        else if (nearFacingAway(x, y)) zones[i] = Zone::TerminatorBand;
    }
    return zones;
}

Verdict verdictOf(Zone zone, float visibility, float exactVisibility)
{
    if (zone == Zone::FacingAway) return Verdict::NotCounted;
    const bool isLit = visibility >= 0.5f, shouldBeLit = exactVisibility >= 0.5f;
    if (isLit == shouldBeLit) return Verdict::Right;
    return isLit ? Verdict::FalseLit : Verdict::FalseShadow;
}

Score score(std::span<const Zone> zones, const Visibility& visibility, std::span<const float> exactVisibility)
{
    LX_ASSERT(zones.size() == visibility.value.size() && zones.size() == exactVisibility.size());
    Score out;
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const Verdict verdict = verdictOf(zones[i], visibility.value[i], exactVisibility[i]);
        if (verdict == Verdict::NotCounted) continue;
        const bool isWrong = verdict != Verdict::Right;
        ++out.lightFacing;
        out.misclassified += isWrong;
        out.falseShadow += verdict == Verdict::FalseShadow;
        out.falseLit += verdict == Verdict::FalseLit;
        out.unserved += !visibility.unserved.empty() && visibility.unserved[i];
        ZoneScore& zone = zones[i] == Zone::EdgeBand         ? out.edgeBand
                          : zones[i] == Zone::TerminatorBand ? out.terminatorBand
                                                             : out.interior;
        ++zone.samples;
        zone.misclassified += isWrong;
    }
    return out;
}

ExecutorAgreement agreement(std::span<const Zone> zones, const Visibility& one, const Visibility& other,
                            std::span<const float> exactVisibility)
{
    LX_ASSERT(zones.size() == one.value.size() && zones.size() == other.value.size());
    ExecutorAgreement out;
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const Verdict a = verdictOf(zones[i], one.value[i], exactVisibility[i]);
        const Verdict b = verdictOf(zones[i], other.value[i], exactVisibility[i]);
        if (a == Verdict::NotCounted) continue;
        ++out.lightFacing;
        out.agreeing += a == b;
        out.misclassifiedByEither += a != Verdict::Right || b != Verdict::Right;
        out.misclassifiedByBoth += a != Verdict::Right && b != Verdict::Right;
    }
    return out;
}

} // namespace lixel
