// SPDX-License-Identifier: MIT
#include "lixel/judge/temporal.h"

#include "lixel/base/assert.h"

namespace lixel {
namespace {

ShadowState rounded(float visibility) { return visibility >= 0.5f ? ShadowState::Lit : ShadowState::Dark; }

ZoneFlips& operator+=(ZoneFlips& one, const ZoneFlips& other)
{
    one.samples += other.samples;
    one.flips += other.flips;
    return one;
}

} // namespace

std::vector<ShadowState> statesOf(const Visibility& visibility)
{
    std::vector<ShadowState> states(visibility.value.size(), ShadowState::None);
    for (std::size_t i = 0; i < states.size(); ++i)
        if (visibility.unserved.empty() || !visibility.unserved[i]) states[i] = rounded(visibility.value[i]);
    return states;
}

std::vector<ShadowState> exactStates(std::span<const Zone> zones, std::span<const float> exactVisibility)
{
    LX_ASSERT(zones.size() == exactVisibility.size());
    std::vector<ShadowState> states(zones.size(), ShadowState::None);
    for (std::size_t i = 0; i < states.size(); ++i)
        if (zones[i] != Zone::FacingAway) states[i] = rounded(exactVisibility[i]);
    return states;
}

std::vector<ShadowState> exactStates(const ViewSamples& samples, const Light& light,
                                     std::span<const float> exactVisibility)
{
    LX_ASSERT(samples.size() == exactVisibility.size());
    std::vector<ShadowState> states(samples.size(), ShadowState::None);
    for (std::size_t i = 0; i < states.size(); ++i)
        if (isLightFacing(light, samples.originWorld, toDouble(samples.positionLocal[i]), toDouble(samples.normal[i])))
            states[i] = rounded(exactVisibility[i]);
    return states;
}

TemporalScore& TemporalScore::operator+=(const TemporalScore& other)
{
    all += other.all;
    edgeBand += other.edgeBand;
    terminatorBand += other.terminatorBand;
    interior += other.interior;
    return *this;
}

TemporalScore temporalScore(const FrameStates& before, std::span<const Zone> zonesBefore, const FrameStates& now,
                            std::span<const std::uint32_t> from)
{
    LX_ASSERT(before.map.size() == zonesBefore.size() && before.exact.size() == zonesBefore.size());
    LX_ASSERT(now.map.size() == from.size() && now.exact.size() == from.size());
    TemporalScore out;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const std::size_t was = from[i];
        if (before.exact[was] == ShadowState::None || before.exact[was] != now.exact[i]) continue;
        if (before.map[was] == ShadowState::None || now.map[i] == ShadowState::None) continue;
        const ZoneFlips one{1, before.map[was] != now.map[i]};
        out.all += one;
        (zonesBefore[was] == Zone::EdgeBand         ? out.edgeBand
         : zonesBefore[was] == Zone::TerminatorBand ? out.terminatorBand
                                                    : out.interior) += one;
    }
    return out;
}

} // namespace lixel
