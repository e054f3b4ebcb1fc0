// SPDX-License-Identifier: MIT
#include "shade_quality.h"

#include "lixel/plan/lookup/lookup.h"
#include "lixel/trace/exact_area.h"
#include "lixel/trace/exact_filtered.h"

namespace lixel::app {
namespace {

ViewSamples samplesOf(const ViewSamples& all, std::span<const std::size_t> which)
{
    ViewSamples some;
    some.width = all.width, some.height = all.height;
    some.originWorld = all.originWorld;
    for (const std::size_t i : which) {
        some.pixel.push_back(all.pixel[i]);
        some.positionLocal.push_back(all.positionLocal[i]);
        some.normal.push_back(all.normal[i]);
        some.triangle.push_back(all.triangle[i]);
    }
    return some;
}

TruthError against(std::span<const float> values, std::span<const float> truth)
{
    const ShadeError error = shadeError(values, truth);
    return {error.rootMeanSquare(), error.largest};
}

} // namespace

std::vector<PartialTruth> findPartialTruth(const Stage& stage, const View& view, const ViewSamples& samples,
                                           std::span<const Light> lights, const Truth& truth, std::size_t step)
{
    std::vector<PartialTruth> out;
    for (std::size_t light = 0; light < lights.size(); ++light) {
        PartialTruth& partial = out.emplace_back();
        const std::vector<Zone>& zones = truth.zones[light];
        std::size_t met = 0;
        for (std::size_t i = 0; i < zones.size(); ++i)
            if (zones[i] == Zone::EdgeBand && met++ % step == 0) partial.band.push_back(i);
        partial.samples = samplesOf(samples, partial.band);
        partial.area = exactArea(*stage.traced, view, partial.samples, lights[light], kAreaRays);
    }
    return out;
}

std::vector<float> valuesOf(std::span<const float> values, std::span<const std::size_t> which)
{
    std::vector<float> some;
    for (const std::size_t i : which) some.push_back(values[i]);
    return some;
}

ShadeQuality shadeQuality(const ShotContext& context, const Visibility& visibility, const FramePlan* plan,
                          std::size_t light)
{
    const PartialTruth& truth = context.truth.partial[light];
    const Shades shades =
        shadesOf(context.samples, context.truth.zones[light], visibility.value, context.truth.exact[light]);
    const std::vector<float> values = valuesOf(visibility.value, truth.band);
    ShadeQuality quality;
    quality.distinct = shades.distinct;
    quality.transitionPixels = shades.transitionPixels();
    quality.bleedingPercent = shades.bleedingPercent();
    quality.darkInterior = {shades.darkInterior, shades.litDarkInterior};
    quality.area = against(values, truth.area);
    if (!plan || !whyNoShare(plan->lookup).empty()) return quality;
    const LixelFilter filter = filterOf(plan->lookup);
    quality.filterLixels = filter.side;
    const std::vector<float> filtered = exactFiltered(*context.stage.traced, plan->lights[light], truth.samples,
                                                      context.shot.lights[light], filter, context.options.filterRays);
    quality.filtered = against(values, filtered);
    return quality;
}

} // namespace lixel::app
