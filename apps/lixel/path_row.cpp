// SPDX-License-Identifier: MIT
#include "path_row.h"

#include <algorithm>

namespace lixel::app {
namespace {

void addTo(SampleCount& sum, const SampleCount& more)
{
    sum.samples += more.samples;
    sum.misclassified += more.misclassified;
}

void addTo(FlipCount& sum, const ZoneFlips& more)
{
    sum.samples += more.samples;
    sum.flips += more.flips;
}

} // namespace

void PathRow::beginFrame(double seconds)
{
    if (temporal_.frames == 0) temporal_.fromSeconds = seconds;
    else temporal_.pairs.push_back({seconds, {}});
    temporal_.toSeconds = seconds;
    ++temporal_.frames;
}

void PathRow::addRefusal(FitFailure reason)
{
    refused_ = reason;
    ++temporal_.refusedFrames;
    states_.reset();
}

void PathRow::add(const Measurement& counts)
{
    sum_.lightFacing += counts.lightFacing;
    sum_.misclassified += counts.misclassified;
    sum_.falseShadow += counts.falseShadow;
    sum_.falseLit += counts.falseLit;
    sum_.unserved += counts.unserved;
    if (sum_.planes.empty()) sum_.planes = counts.planes;
    else
        for (std::size_t i = 0; i < counts.planes.size(); ++i) addTo(sum_.planes[i].count, counts.planes[i].count);
    addTo(sum_.edgeBand, counts.edgeBand);
    addTo(sum_.terminatorBand, counts.terminatorBand);
    addTo(sum_.interior, counts.interior);
}

void PathRow::addMap(std::int64_t lixels, std::int64_t bytesPerLixel)
{
    sum_.lixelsUsed = std::max(sum_.lixelsUsed, lixels);
    sum_.bytes = std::max(sum_.bytes, lixels * bytesPerLixel);
}

void PathRow::add(const Density& density)
{
    const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
    append(pixelsPerLixel_, density.pixelsPerLixelList);
    append(lixelsPerPixel_, density.lixelsPerPixelList);
}

void PathRow::add(const ExecutorAgreement& counts, const LixelAgreement& lixels)
{
    lixels_ += lixels;
    agreement_.lightFacing += counts.lightFacing;
    agreement_.agreeing += counts.agreeing;
    agreement_.misclassifiedByEither += counts.misclassifiedByEither;
    agreement_.misclassifiedByBoth += counts.misclassifiedByBoth;
}

void PathRow::addFlips(const TruthBefore& before, std::span<const std::uint32_t> from, std::span<const ShadowState> map,
                       std::span<const ShadowState> exact)
{
    if (!states_) return;
    const TemporalScore flips = temporalScore({*states_, before.exact}, before.zones, {map, exact}, from);
    addTo(temporal_.pairs.back().count, flips.all);
    addTo(temporal_.all, flips.all);
    addTo(temporal_.edgeBand, flips.edgeBand);
    addTo(temporal_.terminatorBand, flips.terminatorBand);
    addTo(temporal_.interior, flips.interior);
}

void PathRow::keepStates(std::vector<ShadowState> ofSamples) { states_ = std::move(ofSamples); }

void PathRow::show(const PictureFiles& pictures, const RowTiming& timing)
{
    sum_.pictures = pictures;
    sum_.timing = timing;
}

ResultRow PathRow::finished(bool isStill, std::string_view other)
{
    ResultRow out = std::move(row_);
    if (temporal_.refusedFrames == temporal_.frames) {
        out.outcome = Refusal{std::string(nameOf(*refused_)), std::string(sentenceFor(*refused_))};
        return out;
    }
    Measurement m = std::move(sum_);
    m.footprintPixelsPerLixel = percentiles(std::move(pixelsPerLixel_));
    m.densityLixelsPerPixel = percentiles(std::move(lixelsPerPixel_));
    if (!other.empty()) m.agreement = agreementWith(other, agreement_, lixels_);
    m.temporal = std::move(temporal_);
    m.temporal->isStill = isStill;
    out.outcome = std::move(m);
    return out;
}

} // namespace lixel::app
