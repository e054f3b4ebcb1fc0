// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/view_samples.h"
#include "lixel/base/visibility.h"

#include <cstdint>
#include <span>
#include <vector>

// How wrong a technique's shadows are against exact visibility of the same view samples.
namespace lixel {

// Where in the picture a sample lies, seen from one light.
enum class Zone : std::uint8_t {
    FacingAway,     // dark without a test: counts neither right nor wrong
    EdgeBand,       // within 2 pixels of a boundary between lit and shadowed light-facing samples
    TerminatorBand, // else within 2 pixels of a sample that faces away
    Interior,       // all others
};

// Pixels from a boundary, or from a sample facing away, that still belong to its band.
inline constexpr double kBandPixels = 2;

// The zone of every sample. A boundary lies halfway between two pixels that are 4-neighbours, both light-facing and
// of different exact visibility; distances are Euclidean between pixel centres and such points. With several samples in a
// pixel the first one stands for it.
std::vector<Zone> zonesOf(const ViewSamples& samples, const Light& light, std::span<const float> exactVisibility);

struct ZoneScore
{
    std::int64_t samples = 0, misclassified = 0;
    double percent() const { return samples > 0 ? 100.0 * double(misclassified) / double(samples) : 0; }
};

struct Score
{
    std::int64_t lightFacing = 0;
    std::int64_t misclassified = 0; // rounded visibility (0.5 is lit) differs from exact visibility
    std::int64_t falseShadow = 0;   // of these: dark where it should be lit
    std::int64_t falseLit = 0;      // of these: lit where it should be dark
    std::int64_t unserved = 0;      // light-facing samples that no region holds
    ZoneScore edgeBand, terminatorBand, interior;

    double misclassifiedPercent() const
    {
        return lightFacing > 0 ? 100.0 * double(misclassified) / double(lightFacing) : 0;
    }
};

// What one sample comes to.
enum class Verdict : std::uint8_t {
    NotCounted, // faces away
    Right,
    FalseShadow,
    FalseLit,
};
Verdict verdictOf(Zone zone, float visibility, float exactVisibility);

// All arrays have one entry a sample.
Score score(std::span<const Zone> zones, const Visibility& visibility, std::span<const float> exactVisibility);

// Two executors on the same samples and plan: how often they round alike, and how many of their errors they share.
struct ExecutorAgreement
{
    std::int64_t lightFacing = 0, agreeing = 0;
    std::int64_t misclassifiedByEither = 0, misclassifiedByBoth = 0;
    double agreementPercent() const { return lightFacing > 0 ? 100.0 * double(agreeing) / double(lightFacing) : 100; }
    double sharedMisclassifiedPercent() const
    {
        return misclassifiedByEither > 0 ? 100.0 * double(misclassifiedByBoth) / double(misclassifiedByEither) : 100;
    }
};
ExecutorAgreement agreement(std::span<const Zone> zones, const Visibility& one, const Visibility& other,
                            std::span<const float> exactVisibility);

} // namespace lixel
