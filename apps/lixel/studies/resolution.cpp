// SPDX-License-Identifier: MIT
#include "lixel/report/resolution.h"

#include "boundary_energy.h"
#include "exit_code.h"
#include "lixel/judge/smallest_map.h"
#include "one_light.h"
#include "output.h"
#include "progress.h"
#include "run_results.h"
#include "study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

// The paper's promise for offline work (Chong & Gortler 2007, section 1): an error is asked for, and the map that it takes is found. First
// by the width of lixels across the shadow's edge, then measured.
namespace lixel::app {
namespace {

constexpr const char* kBeside = "focused";

// Light images are made for this size; guard bands aside they are the same for all.
constexpr int kAnySide = 512;

TechniqueChoice readTechnique(const std::string& text)
{
    std::vector<TechniqueChoice> all = readTechniques(text);
    if (all.size() != 1) throw UsageError(fmt::format("--technique \"{}\": one technique is expected", text));
    const auto* map = std::get_if<MapTechnique>(&all.front().technique);
    if (!map) throw UsageError(fmt::format("--technique \"{}\" has no map", text));
    if (std::holds_alternative<MatrixFit>(map->fit) || std::holds_alternative<PlanFit>(map->fit))
        throw UsageError(fmt::format("--technique \"{}\": the size of its map is given", text));
    if (std::holds_alternative<DualParaboloidPartition>(map->partition))
        throw UsageError(fmt::format("--technique \"{}\": widths of lixels are foretold for matrices alone", text));
    return all.front();
}

// A boundary between two samples is a pixel long, and a lixel misplaces it by a quarter of its width on the mean.
int sideByMetric(const StudiedPicture& picture, const ShadowPlan& plan, std::span<const NeedSample> boundary,
                 double lightFacing, double tolerancePercent)
{
    const BoundaryEnergy energy(picture.view, picture.samples.originWorld, plan, boundary);
    const double width = kAnySide * energy.mean(LixelMetric::Width).value_or(0);
    const double misclassified = 0.5 * double(boundary.size()) * 0.25 * width; // in a map of one lixel
    const double side = lightFacing > 0 ? 100 * misclassified / lightFacing / tolerancePercent : 0;
    return int(std::clamp(side, double(kSmallestSide), double(kLargestSide)));
}

class LightStudy
{
public:
    LightStudy(const StudiedPicture& picture, const Light& light, double tolerancePercent)
        : picture_(picture), light_(picture, light), tolerance_(tolerancePercent)
    {
        const int side = std::max(picture.view.width, picture.view.height);
        light_.drawLastFrame({side, side});
        boundary_ = light_.boundary();
    }

    ResolutionStudy::Row row(const TechniqueChoice& choice) const
    {
        ResolutionStudy::Row out;
        out.light = light_.light().name;
        out.technique = choice.typed;
        const PlanMemory known = light_.lastFrame();
        const FramePlan any = light_.plan(choice, {kAnySide, kAnySide}, known);
        if (const auto refused = any.lights.front().refused) {
            out.refused = nameOf(*refused);
            return out;
        }
        out.sideByMetric =
            sideByMetric(picture_, any.lights.front(), boundary_, double(light_.lightFacing()), tolerance_);
        const SmallestMap found = smallestMap(tolerance_, out.sideByMetric, [&](int side) {
            const auto score = light_.score(choice, {side, side}, known);
            return score ? score->misclassifiedPercent() : std::numeric_limits<double>::infinity();
        });
        out.sidePredicted = found.predicted;
        out.side = found.side;
        out.misclassifiedPercent = found.percent;
        out.sidesMeasured = found.measured;
        if (found.side) out.lixels = light_.plan(choice, {*found.side, *found.side}, known).lixelsOf(0);
        return out;
    }

private:
    const StudiedPicture& picture_;
    OneLight light_;
    double tolerance_;
    std::vector<NeedSample> boundary_;
};

void print(const ResolutionStudy& study, const std::string& technique, std::FILE* to)
{
    fmt::print(to, "misclassified under {} %, picture {}; sides of square maps\n", study.tolerancePercent, study.size);
    fmt::print(to, "{:<14} {:<12} {:<24} {:>9} {:>9} {:>7} {:>11} {:>15}\n", "view", "light", "technique", "by metric",
               "predicted", "found", "lixels", "misclassified");
    double ours = 0, focused = 0;
    for (std::size_t i = 0; i < study.rows.size(); ++i) {
        const ResolutionStudy::Row& row = study.rows[i];
        fmt::print(to, "{:<14} {:<12} {:<24} ", row.view, row.light, row.technique);
        if (!row.refused.empty()) {
            fmt::print(to, "refused: {}\n", row.refused);
            continue;
        }
        fmt::print(to, "{:>9} {:>9} {:>7} {:>11} {:>13.4f} %\n", row.sideByMetric, row.sidePredicted,
                   row.side ? fmt::format("{}", *row.side) : "-", row.side ? fmt::format("{}", row.lixels) : "-",
                   row.misclassifiedPercent);
        if (!row.side)
            fmt::print(to, "  the largest map, {0}x{0}, misses the tolerance: {1:.4f} %\n", study.largestSide,
                       row.misclassifiedPercent);
        const ResolutionStudy::Row* before = i % 2 == 1 ? &study.rows[i - 1] : nullptr;
        if (before && before->side && row.side) ours += double(before->lixels), focused += double(row.lixels);
    }
    if (technique != kBeside && focused > 0)
        fmt::print(to, "lixels of all lights with both maps: {:.0f} for {}, {:.0f} for {}: {:.1f} % of them\n", ours,
                   technique, focused, kBeside, 100 * ours / focused);
}

} // namespace

int studyResolution(const StudyOptions& options)
{
    ResolutionStudy study;
    study.tolerancePercent = readPercent(options.tolerance, "--tolerance");
    std::vector<TechniqueChoice> techniques{readTechnique(options.technique)};
    const TechniqueChoice beside = readTechniques(kBeside).front();
    if (techniques.front().technique != beside.technique) techniques.push_back(beside);
    const Shooting shooting = prepare(options.picture, true);
    expectPlanes(techniques, shooting);
    const std::unique_ptr<Executor> executor = makeExecutor(options.executor);
    study.scene = shooting.sceneName;
    study.size = fmt::format("{}x{}", shooting.width, shooting.height);
    study.executor = executor->name();
    study.largestSide = kLargestSide;

    int steps = 0;
    for (const Shot& shot : shooting.shots) steps += int(shot.lights.size() * techniques.size());
    const Stopwatch total;
    {
        Progress progress("study resolution", steps);
        for (const Shot& shot : shooting.shots) {
            const StudiedPicture picture(shooting, shot, *executor);
            for (const Light& light : shot.lights) {
                const LightStudy ofLight(picture, light, study.tolerancePercent);
                for (const TechniqueChoice& choice : techniques) {
                    progress.step(fmt::format("{}, {}: {}", shot.name, light.name, choice.typed));
                    study.rows.push_back(ofLight.row(choice));
                    study.rows.back().view = shot.name;
                }
            }
        }
    }
    study.lixelVersion = LIXEL_VERSION;
    study.command = options.commandLine;
    study.timing = timingNow(total.seconds(), executor->host());
    if (!options.json.empty()) writeOrPrint(options.json, toJson(study));
    tellWarnings(*shooting.scene);
    print(study, options.technique, options.json == "-" ? stderr : stdout);
    const bool isRefused = std::ranges::all_of(study.rows, [](const auto& row) { return !row.refused.empty(); });
    return isRefused ? kRefused : kDone;
}

} // namespace lixel::app
