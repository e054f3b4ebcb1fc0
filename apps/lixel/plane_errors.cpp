// SPDX-License-Identifier: MIT
#include "plane_errors.h"

#include "lixel/trace/plane_probe.h"

namespace lixel::app {
std::vector<std::optional<PlaneErrorCauses>> causesOfPlaneErrors(const JudgedSamples& judged, std::size_t planes)
{
    std::vector<std::optional<PlaneErrorCauses>> out(planes);
    const std::vector<PlannedRegion>& regions = judged.plan.lights[judged.lightNumber].regions;
    std::vector<std::size_t> regionOf(planes, regions.size());
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (regions[i].plane < 0 || regions[i].plane >= int(planes) || !regions[i].pixelPlaneLocal) continue;
        regionOf[std::size_t(regions[i].plane)] = i;
        out[std::size_t(regions[i].plane)].emplace();
    }
    for (std::size_t i = 0; i < judged.samples.size(); ++i) {
        const Verdict verdict = judged.verdict[i];
        if (judged.plane[i] == kOnNoPlane || verdict == Verdict::Right || verdict == Verdict::NotCounted) continue;
        const auto plane = std::size_t(judged.plane[i]);
        if (!out[plane]) continue;
        const PlaneProbe probe = probeOnPlane(judged.scene, judged.plan, judged.lightNumber, regionOf[plane],
                                              judged.light, judged.samples, i, kBesideLixels);
        out[plane]->add(causeOfPlaneError(judged.exact[i], probe.exactBeside, probe.isNearCaster));
    }
    return out;
}

} // namespace lixel::app
