// SPDX-License-Identifier: MIT
#include "lixel/plan/technique.h"

#include "lixel/plan/exact_words.h"
#include "lixel/plan/lookup/lookup_words.h"
#include "lixel/plan/partition/dual_paraboloid_text.h"
#include "lixel/plan/partition/planes.h"
#include "lixel/plan/technique_presets.h"
#include "lixel/plan/technique_text.h"
#include "lixel/plan/warp/warp_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace lixel {
namespace {

std::string knownWords()
{
    std::string names;
    for (const TechniqueWord& word : techniqueWords())
        names += (names.empty() ? "" : ", ") + std::string(word.form.substr(0, word.form.find_first_of("(=")));
    return names;
}

// What one word sets; at most one of each kind.
struct Parts
{
    std::optional<Partition> partition;
    std::optional<FitChoice> fit;
    bool isStable = false;
    std::optional<Allocation> allocation;
    std::optional<Fallback> otherwise;
    std::optional<WarpChoice> warp;
    LookupParts lookup;
    std::optional<Technique> noMap;

    bool anyOfMap() const { return partition || fit || isStable || allocation || otherwise || warp || lookup.any(); }
};

template <typename Slot, typename Value>
std::string setOnce(Slot& slot, const Value& value, std::string_view kind)
{
    if (slot) return fmt::format("more than one {}", kind);
    slot = value;
    return "";
}

// Each of these reads one kind of word: an empty string, what is wrong with it, or nothing where it is another kind's.
using Answer = std::optional<std::string>;

Answer takePartition(const Word& word, Parts& parts)
{
    Arguments arguments(word);
    if (word.name == "whole" || word.name == "cube") {
        if (!arguments.areAllTaken()) return fmt::format("\"{}\" takes no arguments", word.name);
        if (word.name == "whole") return setOnce(parts.partition, Partition(WholePartition{}), "partition");
        return setOnce(parts.partition, Partition(CubePartition{}), "partition");
    }
    if (word.name != "pssm" && word.name != "sdsm") return std::nullopt;
    parts.isStable |= arguments.takeFlag("stable");
    const auto countText = arguments.take("n", true);
    const auto count = countText ? readInteger(*countText) : std::optional(4);
    if (!count || *count < 1 || *count > 16) return fmt::format("{}(n) takes n = 1 to 16", word.name);
    if (word.name == "sdsm") {
        if (!arguments.areAllTaken()) return "sdsm takes a number of regions and stable";
        return setOnce(parts.partition, Partition(SdsmPartition{*count}), "partition");
    }
    const auto lambdaText = arguments.take("lambda");
    const auto lambda = lambdaText ? readNumber(*lambdaText) : std::optional(0.5);
    if (!lambda || *lambda < 0 || *lambda > 1) return "pssm takes lambda = 0 to 1";
    if (!arguments.areAllTaken()) return "pssm takes a number of regions, lambda = 0 to 1 and stable";
    return setOnce(parts.partition, Partition(PssmPartition{*count, *lambda}), "partition");
}

Answer takeDualParaboloid(const Word& word, Parts& parts)
{
    const auto partition = readDualParaboloid(word);
    if (!partition) return std::nullopt;
    return *partition ? setOnce(parts.partition, Partition(**partition), "partition") : partition->error();
}

std::optional<Twist> twistNamed(std::string_view name)
{
    if (name == "none") return Twist::None;
    if (name == "tight") return Twist::Tight;
    if (name == "line") return Twist::Line;
    return std::nullopt;
}

// planes(floor, wall, twist=line), planes(auto).
Answer takePlanes(const Word& word, Parts& parts)
{
    if (word.name != "planes") return std::nullopt;
    Arguments arguments(word);
    PlanesPartition planes;
    if (const auto text = arguments.take("twist")) {
        const auto twist = twistNamed(*text);
        if (!twist) return "planes takes twist=none, twist=tight or twist=line";
        planes.twist = *twist;
    }
    const bool isAuto = arguments.takeFlag("auto");
    for (const std::string_view name : arguments.rest()) {
        if (name.empty() || name.find_first_of("=+()") != std::string_view::npos)
            return fmt::format("\"{}\" is no name of a plane", name);
        if (std::find(planes.names.begin(), planes.names.end(), name) != planes.names.end())
            return fmt::format("plane \"{}\" twice", name);
        planes.names.emplace_back(name);
    }
    if (isAuto == !planes.names.empty()) return "planes takes names of planes, or auto";
    if (planes.names.size() > kMostPlanes) return fmt::format("planes takes {} planes at most", kMostPlanes);
    return setOnce(parts.partition, Partition(planes), "partition");
}

Answer takePlaneOptimal(const Word& word, Parts& parts)
{
    if (word.name != "plane-optimal") return std::nullopt;
    Arguments arguments(word);
    PlaneOptimalFit fit;
    fit.isOfSamples = arguments.takeFlag("desired-view");
    if (const auto uncovered = arguments.take("uncovered")) {
        if (*uncovered != "lit")
            return "plane-optimal takes uncovered=lit; without it, what is not covered goes to else(...)";
        fit.uncoveredIsLit = true;
    }
    if (!arguments.areAllTaken()) return "plane-optimal takes desired-view and uncovered=lit";
    return setOnce(parts.fit, FitChoice(fit), "fit");
}

Answer takeFit(const Word& word, Parts& parts)
{
    Arguments arguments(word);
    std::optional<FitChoice> fit;
    if (word.name == "uniform") fit = UniformFit{};
    if (word.name == "focused") fit = FocusedFit{};
    if (word.name == "minimal-frustum") fit = MinimalFrustumFit{};
    if (word.name == "lispsm") fit = LispsmFit{};
    if (word.name == "desired-view") fit = DesiredViewFit{arguments.takeFlag("rotated")};
    if (word.name == "psm") {
        const std::string_view shift = arguments.take("shift").value_or("casters");
        if (shift != "casters" && shift != "none") return "psm takes shift=casters or shift=none";
        fit = PsmFit{shift == "none" ? PsmShift::None : PsmShift::Casters};
    }
    if (word.name == "tsm") {
        TsmFit tsm;
        if (const auto focus = arguments.take("focus")) {
            tsm.focusDepth = readNumber(*focus);
            if (!tsm.focusDepth || !(*tsm.focusDepth > 0)) return "tsm takes focus = a depth above 0";
        }
        fit = tsm;
    }
    if (word.name == "matrix" || word.name == "plan") {
        const auto file = arguments.take("file", true);
        if (!file || file->empty()) return fmt::format("{}(file) needs a file", word.name);
        if (word.name == "matrix") fit = MatrixFit{std::string(*file)};
        else fit = PlanFit{std::string(*file)};
    }
    if (!fit) return std::nullopt;
    if (word.name == "focused" || word.name == "lispsm") parts.isStable |= arguments.takeFlag("stable");
    if (!arguments.areAllTaken()) return fmt::format("\"{}\" does not take these arguments", word.name);
    return setOnce(parts.fit, *fit, "fit");
}

Answer takeWarp(const Word& word, Parts& parts)
{
    const auto warp = readWarp(word);
    if (!warp) return std::nullopt;
    return *warp ? setOnce(parts.warp, **warp, "warp") : warp->error();
}

Answer takeLookupWord(const Word& word, Parts& parts) { return takeLookup(word, parts.lookup); }

Answer takeNoMap(const Word& word, Parts& parts)
{
    if (word.name != "shadow-volumes") return takeExact(word, parts.noMap);
    if (!word.arguments.empty()) return "\"shadow-volumes\" takes no arguments";
    const Technique volumes = ShadowVolumesTechnique{};
    return setOnce(parts.noMap, volumes, "technique without a map");
}

Answer takeAllocation(const Word& word, Parts& parts)
{
    if (!word.arguments.empty() || !word.name.starts_with("allocation")) return std::nullopt;
    const std::size_t equals = word.name.find('=');
    if (equals == std::string_view::npos || trimmed(word.name.substr(0, equals)) != "allocation") return std::nullopt;
    const std::string_view value = trimmed(word.name.substr(equals + 1));
    if (value == "need") return setOnce(parts.allocation, Allocation::Need, "allocation");
    if (value == "share") return setOnce(parts.allocation, Allocation::Share, "allocation");
    if (value == "exact") return setOnce(parts.allocation, Allocation::Exact, "allocation");
    return "allocation= takes need, share or exact";
}

bool isPlanes(const Partition& partition) { return std::holds_alternative<PlanesPartition>(partition); }

FitChoice fitOr(const Parts& parts)
{
    if (parts.fit) return *parts.fit;
    if (parts.partition && isPlanes(*parts.partition)) return PlaneOptimalFit{};
    const bool isSdsm = parts.partition && std::holds_alternative<SdsmPartition>(*parts.partition);
    if (isSdsm && !parts.isStable) return DesiredViewFit{};
    return FocusedFit{};
}

bool isGiven(const FitChoice& fit)
{
    return std::holds_alternative<MatrixFit>(fit) || std::holds_alternative<PlanFit>(fit);
}

constexpr double kKeepsNothing = std::numeric_limits<double>::infinity();

// A number by name, where it is given; false where it is none or beyond its bounds.
bool takeWithin(Arguments& arguments, std::string_view name, double least, double most, double& into)
{
    const auto text = arguments.take(name);
    if (!text) return true;
    const auto number = readNumber(*text);
    if (!number || !(*number >= least && *number <= most)) return false;
    into = *number;
    return true;
}

bool takeWithin(Arguments& arguments, std::string_view name, int least, int most, int& into)
{
    const auto text = arguments.take(name);
    if (!text) return true;
    const auto number = readInteger(*text);
    if (!number || *number < least || *number > most) return false;
    into = *number;
    return true;
}

Answer takeSceneOptimal(const Word& word, Parts& parts)
{
    if (word.name != "scene-optimal") return std::nullopt;
    Arguments arguments(word);
    SceneOptimalFit fit;
    if (const auto metric = arguments.take("metric")) {
        const std::array known{LixelMetric::L2, LixelMetric::Lloyd, LixelMetric::Area, LixelMetric::Width};
        const auto found =
            std::find_if(known.begin(), known.end(), [&](LixelMetric m) { return nameOf(m) == *metric; });
        if (found == known.end()) return "scene-optimal takes metric=l2, lloyd, area or width";
        fit.metric = *found;
    }
    if (const auto search = arguments.take("search")) {
        if (*search != "paper" && *search != "wide") return "scene-optimal takes search=paper or search=wide";
        if (*search == "paper") fit.search = MapSearchKind::Descent;
    }
    const auto extent = arguments.take("holds");
    if (extent && *extent != "shadows" && *extent != "seen") return "scene-optimal takes holds=shadows or holds=seen";
    if (const auto text = arguments.take("iterations")) {
        const auto iterations = readInteger(*text);
        if (!iterations || *iterations < 0 || *iterations > 100 || fit.search != MapSearchKind::Descent)
            return "scene-optimal takes iterations = 0 to 100, with search=paper";
        fit.iterations = *iterations;
    }
    if (!takeWithin(arguments, "slack", 0.0, 1.0, fit.slack)) return "scene-optimal takes slack = 0 to 1";
    if (!takeWithin(arguments, "weight", 0.0, 1.0, fit.awayFromBoundaries))
        return "scene-optimal takes weight = 0 to 1";
    if (!takeWithin(arguments, "samples", 8, 2048, fit.samples)) return "scene-optimal takes samples = 8 to 2048";
    if (const auto text = arguments.take("keep")) {
        const auto keep = *text == "none" ? std::optional(kKeepsNothing) : readNumber(*text);
        if (!keep || *keep < 0) return "scene-optimal takes keep = a number from 0, or keep=none";
        fit.keep = *keep;
    }
    if (!takeWithin(arguments, "update", 1, 1000, fit.update)) return "scene-optimal takes update = 1 to 1000 frames";
    if (const auto uncovered = arguments.take("uncovered")) {
        if (*uncovered != "lit")
            return "scene-optimal takes uncovered=lit; without it, what is not covered goes to else(...)";
        fit.uncoveredIsLit = true;
    }
    // A second map for what is lit all around costs more than it brings; where nothing serves that, nothing is lost.
    fit.extent =
        extent.value_or(fit.uncoveredIsLit ? "shadows" : "seen") == "seen" ? MapExtent::Seen : MapExtent::Shadows;
    fit.hasShear = arguments.takeFlag("shear");
    if (!arguments.areAllTaken())
        return "scene-optimal takes metric=, search=, holds=, iterations=, slack=, weight=, samples=, keep=, update=, "
               "shear "
               "and uncovered=lit";
    return setOnce(parts.fit, FitChoice(fit), "fit");
}

// A partition and a fit, and nothing else.
Answer takeElse(const Word& word, Parts& parts)
{
    if (word.name != "else") return std::nullopt;
    if (word.arguments.size() != 1) return "else(...) takes a fit, or a partition and a fit joined by +";
    const auto pieces = split(word.arguments.front(), '+');
    Parts inside;
    for (const std::string_view piece : pieces.value_or(std::vector<std::string_view>{})) {
        const auto part = readWord(piece);
        if (!part) return fmt::format("\"{}\" is not of the form word(value, ...)", piece);
        Answer answer = takePartition(*part, inside);
        if (!answer) answer = takeFit(*part, inside);
        if (!answer) answer = takeSceneOptimal(*part, inside);
        if (!answer && part->name == "dual-paraboloid")
            return "dual-paraboloid serves all light rays by itself, not in else(...)";
        if (!answer && (part->name == "planes" || part->name == "plane-optimal"))
            return "planes and plane-optimal go before else(...), not into it";
        if (!answer) return fmt::format("else(...) takes a partition and a fit, not \"{}\"", piece);
        if (!answer->empty()) return answer;
    }
    if (inside.isStable) return "stable stands outside else(...) and is the whole technique's";
    const Fallback fallback{inside.partition.value_or(WholePartition{}), fitOr(inside)};
    if (isGiven(fallback.fit)) return "else(...) takes no matrix(file) and no plan(file)";
    return setOnce(parts.otherwise, fallback, "else(...)");
}

// An empty string, or what is wrong with the word.
std::string take(const Word& word, Parts& parts)
{
    for (const auto reader : {takePartition, takeDualParaboloid, takePlanes, takeFit, takePlaneOptimal,
                              takeSceneOptimal, takeWarp, takeLookupWord, takeNoMap, takeAllocation, takeElse})
        if (const Answer answer = reader(word, parts)) return *answer;
    return fmt::format("\"{}\" is not known; known are {}", word.name, knownWords());
}

// All words of a text; an empty string, or what is wrong with one.
std::string takeAll(std::string_view text, Parts& parts)
{
    const auto pieces = split(text, '+');
    if (!pieces) return "parentheses do not match";
    for (const std::string_view piece : *pieces) {
        if (piece.empty()) return "an empty word";
        const auto word = readWord(piece);
        if (!word) return fmt::format("\"{}\" is not of the form word(value, ...)", piece);
        if (word->name != "paper") {
            if (const std::string wrong = take(*word, parts); !wrong.empty()) return wrong;
            continue;
        }
        const auto words = word->arguments.size() == 1 ? presetNamed(word->arguments.front()) : std::nullopt;
        if (!words) return "paper takes rtw, now, now-dv or min-sm";
        if (const std::string wrong = takeAll(*words, parts); !wrong.empty()) return wrong;
    }
    return "";
}

// What planes bring along: what they do not hold goes to else(...), and maps of planes(auto), which is made from view samples, hold no
// more than those.
void completePlanes(MapTechnique& technique)
{
    auto* fit = std::get_if<PlaneOptimalFit>(&technique.fit);
    const auto* planes = std::get_if<PlanesPartition>(&technique.partition);
    if (!planes) return;
    const bool isAuto = planes->names.empty();
    if (fit) fit->isOfSamples |= isAuto;
    if ((fit && fit->uncoveredIsLit) || technique.otherwise) return;
    technique.otherwise = isAuto ? Fallback{WholePartition{}, DesiredViewFit{true}} : Fallback{};
}

// What goes together, one line each; empty, or what does not.
std::string checkTogether(const MapTechnique& map, const Parts& parts)
{
    if (std::holds_alternative<DualParaboloidPartition>(map.partition))
        if (const std::string wrong = checkDualParaboloid(map); !wrong.empty()) return wrong;
    const bool isWhole = std::holds_alternative<WholePartition>(map.partition);
    const bool canBeStable = std::holds_alternative<FocusedFit>(map.fit) || std::holds_alternative<LispsmFit>(map.fit);
    if (map.isStable && map.allocation == Allocation::Need)
        return "allocation=need follows the view samples: a stable technique takes allocation=share";
    if (map.isStable && !canBeStable) return "stable goes with focused and lispsm";
    if (map.isStable && !isWhole && std::holds_alternative<LispsmFit>(map.fit))
        return "lispsm(stable) goes with no partition: cells follow the camera, and it with them";
    const auto* planeOptimal = std::get_if<PlaneOptimalFit>(&map.fit);
    if (planeOptimal && !isPlanes(map.partition)) return "plane-optimal needs regions with planes: planes(...)";
    if (planeOptimal && planeOptimal->uncoveredIsLit && map.otherwise)
        return "uncovered=lit leaves nothing to else(...)";
    const auto* sceneOptimal = std::get_if<SceneOptimalFit>(&map.fit);
    if (sceneOptimal && sceneOptimal->uncoveredIsLit && map.otherwise)
        return "uncovered=lit leaves nothing to else(...)";
    if (map.isStable && isPlanes(map.partition))
        return "stable goes with no planes(...): their maps follow the picture";
    if (parts.warp && map.isStable) return "a warp follows what is seen: it goes with nothing stable";
    if (parts.warp && map.allocation == Allocation::Exact)
        return "allocation=exact has its lixels where pixels are: no warp goes with it";
    if (parts.warp && isGiven(map.fit))
        return "matrix(file) and plan(file) are taken as they are: no warp goes with them";
    if (map.allocation == Allocation::Exact && !planeOptimal) return "allocation=exact goes with plane-optimal";
    if (isGiven(map.fit) && !isWhole)
        return "matrix(file) and plan(file) have their own regions: no partition goes with them";
    if (parts.allocation && isWhole && !map.otherwise) return "allocation= needs more than one region";
    if (parts.allocation && std::holds_alternative<PlanFit>(map.fit)) return "plan(file) has its own rectangles";
    return "";
}

} // namespace

Expected<Technique, std::string> parseTechnique(std::string_view text)
{
    const auto fail = [&](const std::string& what) {
        return Unexpected{fmt::format("technique \"{}\": {}", text, what)};
    };
    Parts parts;
    if (const std::string wrong = takeAll(text, parts); !wrong.empty()) return fail(wrong);
    if (parts.noMap && parts.anyOfMap()) return fail("a technique without a map stands alone");
    if (parts.noMap) return *parts.noMap;
    MapTechnique technique;
    technique.partition = parts.partition.value_or(WholePartition{});
    technique.fit = fitOr(parts);
    technique.isStable = parts.isStable;
    technique.allocation = parts.allocation.value_or(parts.isStable ? Allocation::Share : Allocation::Need);
    technique.otherwise = parts.otherwise;
    completePlanes(technique);
    if (const auto* fit = std::get_if<SceneOptimalFit>(&technique.fit);
        fit && !fit->uncoveredIsLit && !technique.otherwise)
        technique.otherwise = Fallback{};
    if (parts.warp) technique.warp = *parts.warp;
    auto* paraboloids = std::get_if<DualParaboloidPartition>(&technique.partition);
    if (paraboloids && !parts.warp && !paraboloids->raster) paraboloids->raster = WarpRaster::Exact;
    if (parts.lookup.store) technique.store = *parts.lookup.store;
    if (parts.lookup.kernel) technique.kernel = *parts.lookup.kernel;
    technique.isDualPlane = parts.lookup.isDualPlane;
    if (const std::string wrong = checkLookup(technique); !wrong.empty()) return fail(wrong);
    if (const std::string wrong = checkTogether(technique, parts); !wrong.empty()) return fail(wrong);
    return Technique(technique);
}

bool needsViewSamples(const MapTechnique& technique)
{
    const auto isMadeOfThem = [](const Partition& partition, const FitChoice& fit) {
        const auto* planes = std::get_if<PlanesPartition>(&partition);
        const auto* planeOptimal = std::get_if<PlaneOptimalFit>(&fit);
        return std::holds_alternative<SdsmPartition>(partition) || std::holds_alternative<DesiredViewFit>(fit) ||
               std::holds_alternative<SceneOptimalFit>(fit) || (planes && planes->names.empty()) ||
               (planeOptimal && planeOptimal->isOfSamples);
    };
    return warpOptionsOf(technique.warp) || isMadeOfThem(technique.partition, technique.fit) ||
           (technique.otherwise && isMadeOfThem(technique.otherwise->partition, technique.otherwise->fit));
}

const MapTechnique* mapsOf(const Technique& technique)
{
    if (const auto* exact = std::get_if<ExactFilteredTechnique>(&technique)) return &exact->filtered;
    return std::get_if<MapTechnique>(&technique);
}

bool hasMap(const Technique& technique) { return std::holds_alternative<MapTechnique>(technique); }

WarpRaster rasterOf(const MapTechnique& technique)
{
    if (const WarpOptions* warp = warpOptionsOf(technique.warp)) return warp->raster;
    const auto* paraboloids = std::get_if<DualParaboloidPartition>(&technique.partition);
    return paraboloids ? paraboloids->raster.value_or(WarpRaster::Exact) : WarpRaster::Exact;
}

const SceneOptimalFit* sceneOptimalOf(const MapTechnique& technique)
{
    if (const auto* fit = std::get_if<SceneOptimalFit>(&technique.fit)) return fit;
    return technique.otherwise ? std::get_if<SceneOptimalFit>(&technique.otherwise->fit) : nullptr;
}

Expected<std::vector<std::string>, std::string> splitTechniques(std::string_view list)
{
    const auto parts = split(list, ',');
    if (!parts) return Unexpected{fmt::format("techniques \"{}\": parentheses do not match", list)};
    std::vector<std::string> out;
    for (const std::string_view part : *parts) {
        if (part.empty()) return Unexpected{fmt::format("techniques \"{}\": an empty entry", list)};
        out.emplace_back(part);
    }
    return out;
}

} // namespace lixel
