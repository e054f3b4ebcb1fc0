// SPDX-License-Identifier: MIT
#include "lixel/plan/lookup/lookup_words.h"
#include "lixel/plan/technique.h"

#include "lixel/plan/warp/warp_text.h"

#include <limits>

#include <fmt/format.h>

// Techniques as canonical text.
namespace lixel {
namespace {

std::string name(const WholePartition&) { return "whole"; }
std::string name(const CubePartition&) { return "cube"; }
std::string name(const DualParaboloidPartition& paraboloids)
{
    return paraboloids.raster ? fmt::format("dual-paraboloid(raster={})", nameOf(*paraboloids.raster))
                              : "dual-paraboloid";
}
std::string name(const PssmPartition& pssm) { return fmt::format("pssm({},lambda={})", pssm.count, pssm.lambda); }
std::string name(const SdsmPartition& sdsm) { return fmt::format("sdsm({})", sdsm.count); }
std::string_view nameOf(Twist twist)
{
    if (twist == Twist::None) return "none";
    return twist == Twist::Tight ? "tight" : "line";
}

std::string name(const PlanesPartition& planes)
{
    std::string names = planes.names.empty() ? "auto" : "";
    for (const std::string& plane : planes.names) names += (names.empty() ? "" : ",") + plane;
    return fmt::format("planes({},twist={})", names, nameOf(planes.twist));
}
std::string name(const PlaneOptimalFit& fit)
{
    std::string arguments = fit.isOfSamples ? "desired-view" : "";
    if (fit.uncoveredIsLit) arguments += arguments.empty() ? "uncovered=lit" : ",uncovered=lit";
    return arguments.empty() ? "plane-optimal" : "plane-optimal(" + arguments + ")";
}
std::string name(const UniformFit&) { return "uniform"; }
std::string name(const FocusedFit&) { return "focused"; }
std::string name(const DesiredViewFit& fit) { return fit.isRotated ? "desired-view(rotated)" : "desired-view"; }
std::string name(const MinimalFrustumFit&) { return "minimal-frustum"; }
std::string name(const PsmFit& fit) { return fit.shift == PsmShift::None ? "psm(shift=none)" : "psm(shift=casters)"; }
std::string name(const TsmFit& fit)
{
    return fit.focusDepth ? fmt::format("tsm(focus={})", *fit.focusDepth) : std::string("tsm");
}
std::string name(const LispsmFit&) { return "lispsm"; }
std::string name(const SceneOptimalFit& fit)
{
    const bool isPaper = fit.search == MapSearchKind::Descent;
    const std::string keep = fit.keep == std::numeric_limits<double>::infinity() ? "none" : fmt::format("{}", fit.keep);
    return fmt::format(
        "scene-optimal(metric={},search={}{},holds={},slack={},weight={},samples={},keep={},update={}{}{})",
        nameOf(fit.metric), isPaper ? "paper" : "wide", isPaper ? fmt::format(",iterations={}", fit.iterations) : "",
        fit.extent == MapExtent::Seen ? "seen" : "shadows", fit.slack, fit.awayFromBoundaries, fit.samples, keep,
        fit.update, fit.hasShear ? ",shear" : "", fit.uncoveredIsLit ? ",uncovered=lit" : "");
}
std::string name(const MatrixFit& fit) { return fmt::format("matrix({})", fit.file); }
std::string name(const PlanFit& fit) { return fmt::format("plan({})", fit.file); }
std::string name(const ExactTechnique&) { return "exact"; }
std::string name(const ExactAreaTechnique& area) { return fmt::format("exact-area({})", area.samples); }
std::string name(const ShadowVolumesTechnique&) { return "shadow-volumes"; }

template <typename... Choices>
std::string nameOfChoice(const std::variant<Choices...>& choice)
{
    return std::visit([](const auto& c) { return name(c); }, choice);
}

std::string_view nameOf(Allocation allocation)
{
    if (allocation == Allocation::Need) return "need";
    return allocation == Allocation::Share ? "share" : "exact";
}

// `stable` is written with the fit.
std::string name(const MapTechnique& map)
{
    const std::string fit = nameOfChoice(map.fit) + (map.isStable ? "(stable)" : "");
    std::string text = nameOfChoice(map.partition) + "+" + fit;
    if (map.otherwise)
        text += "+else(" + nameOfChoice(map.otherwise->partition) + "+" + nameOfChoice(map.otherwise->fit) + ")";
    if (map.otherwise || !std::holds_alternative<WholePartition>(map.partition))
        text += fmt::format("+allocation={}", nameOf(map.allocation));
    if (warpOptionsOf(map.warp)) text += "+" + nameOf(map.warp);
    return text + "+" + nameOfLookup(map);
}

std::string name(const ExactFilteredTechnique& exact)
{
    return fmt::format("exact-filtered({},rays={})", name(exact.filtered), exact.rays);
}

} // namespace

std::string toString(const Technique& technique)
{
    return std::visit([](const auto& t) { return name(t); }, technique);
}

} // namespace lixel
