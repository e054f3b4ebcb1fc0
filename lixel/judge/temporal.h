// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/visibility.h"
#include "lixel/judge/carried_samples.h"
#include "lixel/judge/score.h"

#include <cstdint>
#include <span>
#include <vector>

// How unsteady a technique's shadows are from frame to frame.
//
//   A temporal flip is a surface point whose shadow changes from one frame to the next although it should not: looked up
//   in the maps of both frames, its rounded visibility differs, while exact visibility of the same point is the same. What
//   is asked are the view samples of the first frame, carried to the second (carried_samples.h) and seen there too. Edges
//   of still shadows that crawl or shimmer while the camera moves are such flips; an edge that is wrong, but wrong in the
//   same place in both frames, is none.
namespace lixel {

// What is said of one surface point in one frame.
enum class ShadowState : std::uint8_t {
    None, // nothing that could be compared
    Dark,
    Lit,
};

// Rounded (0.5 is lit); None where no region holds the sample.
std::vector<ShadowState> statesOf(const Visibility& visibility);

// What is true; None where the sample faces away from the light.
std::vector<ShadowState> exactStates(std::span<const Zone> zones, std::span<const float> exactVisibility);
std::vector<ShadowState> exactStates(const ViewSamples& samples, const Light& light,
                                     std::span<const float> exactVisibility);

struct ZoneFlips
{
    std::int64_t samples = 0, flips = 0;
    double percent() const { return samples > 0 ? 100.0 * double(flips) / double(samples) : 0; }
};

// `samples` are the points that could flip: light-facing and served in both frames, with the same exact visibility. Zones are
// those of the first frame's picture.
struct TemporalScore
{
    ZoneFlips all, edgeBand, terminatorBand, interior;
    TemporalScore& operator+=(const TemporalScore& other);
};

// States of one light's samples in a frame, an entry a sample.
struct FrameStates
{
    std::span<const ShadowState> map, exact;
};

// `now` has an entry for each carried sample; `before` and `zonesBefore` for each sample that they were carried `from`.
TemporalScore temporalScore(const FrameStates& before, std::span<const Zone> zonesBefore, const FrameStates& now,
                            std::span<const std::uint32_t> from);

} // namespace lixel
