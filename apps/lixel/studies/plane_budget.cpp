// SPDX-License-Identifier: MIT
#include "lixel/report/plane_budget.h"

#include "comparison.h"
#include "finish_study.h"
#include "run_results.h"
#include "study.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

// One map focused on the view against maps for the scene's planes of interest, with ever more lixels; at last a lixel for every pixel
// that sees a plane, and what is left of the largest budget for the rest. Over the views of a scene, on planes and off them apart.
namespace lixel::app {
namespace {

constexpr std::array<const char*, 3> kScenes{"bunnies", "table", "objects"};
constexpr const char* kExactly = "+allocation=exact";

struct Sizes
{
    const char* picture;
    std::array<int, 7> sides; // of square budgets; the last one also pays for a lixel a pixel
};
constexpr Sizes kSizes{"1024x1024", {256, 362, 512, 724, 1024, 1448, 2048}};
constexpr Sizes kQuickSizes{"256x256", {64, 90, 128, 181, 256, 362, 512}};
constexpr int kQuickViews = 1;

std::string squareOf(int side) { return fmt::format("{0}x{0}", side); }

// All planes that the scene names. Polygons go first: a table hides the floor from the light.
std::string planesOf(const Shooting& shooting)
{
    std::vector<NamedPlane> planes = shooting.planes;
    std::ranges::stable_partition(planes, [](const NamedPlane& plane) { return !plane.polygonWorld.empty(); });
    std::string names;
    for (const NamedPlane& plane : planes) names += (names.empty() ? "" : ",") + plane.name;
    return fmt::format("planes({})+plane-optimal", names);
}

std::vector<ResultRow> rowsOfShot(const Shooting& shooting, const Shot& shot, std::span<const int> sides,
                                  std::span<const std::unique_ptr<Executor>> executors, Progress& progress)
{
    const std::string planes = planesOf(shooting);
    const Stage stage = makeStage(shooting.scene, shooting.evaluateOptions, originOf(shooting, shot));
    const View view = viewOf(shooting, shot);
    const ViewSamples samples = executors.front()->viewSamples(stage, view);
    const Truth truth = findTruth(stage, samples, shot.lights, shooting.planes);
    std::vector<ResultRow> rows;
    for (const int side : sides) {
        ComparisonOptions options;
        const bool isLargest = side == sides.back();
        options.techniques = readTechniques("focused," + planes + (isLargest ? "," + planes + kExactly : ""));
        options.lixels.total = {side, side};
        options.timingFrames = 0;
        std::vector<ResultRow> some = compareTechniques({shooting, shot, stage, view, samples, truth, options},
                                                        executors, [&](std::string_view now) { progress.step(now); });
        rows.insert(rows.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
    }
    return rows;
}

// A view and one of its lights.
using Place = std::tuple<std::string, std::string, std::string>;
Place placeOf(const ResultRow& row) { return {row.scene, row.view, row.light}; }

// Curves over the same views and lights each, so that they can be held against each other.
void makeCurves(std::span<const int> sides, PlaneBudget& study)
{
    std::set<Place> refused;
    for (const ResultRow& row : study.run.rows)
        if (row.refused()) refused.insert(placeOf(row));
    study.leftOut = int(refused.size());

    struct Sum
    {
        SampleCount on, off;
        double lixels = 0;
        int rows = 0;
    };
    std::map<std::tuple<std::string, std::string, std::string>, Sum> sums; // scene, technique, budget
    for (const ResultRow& row : study.run.rows) {
        if (refused.contains(placeOf(row))) continue;
        const Measurement& m = *row.measured();
        Sum& sum = sums[{row.scene, row.technique, row.lixels}];
        for (const PlaneSamples& plane : m.planes) {
            SampleCount& count = plane.plane.empty() ? sum.off : sum.on;
            count.samples += plane.count.samples;
            count.misclassified += plane.count.misclassified;
        }
        sum.lixels += double(m.lixelsUsed);
        ++sum.rows;
    }
    std::set<std::pair<std::string, std::string>> lines;
    for (const auto& [key, sum] : sums) lines.insert({std::get<0>(key), std::get<1>(key)});
    for (const auto& [scene, technique] : lines)
        for (const bool isOnPlanes : {true, false}) {
            PlaneBudget::Curve& curve = study.curves.emplace_back(PlaneBudget::Curve{scene, technique, isOnPlanes, {}});
            for (const int side : sides) {
                const auto found = sums.find({scene, technique, squareOf(side)});
                if (found == sums.end()) continue;
                const Sum& sum = found->second;
                curve.points.push_back({squareOf(side), sum.lixels / sum.rows, isOnPlanes ? sum.on : sum.off});
            }
        }
}

void print(const PlaneBudget& study, std::FILE* to)
{
    fmt::print(to, "{:<10} {:<52} {:<8} {:>12} {:>12} {:>14}\n", "scene", "technique", "on", "lixels", "samples",
               "misclassified");
    for (const PlaneBudget::Curve& curve : study.curves)
        for (const PlaneBudget::Point& point : curve.points)
            fmt::print(to, "{:<10} {:<52} {:<8} {:>12.0f} {:>12} {:>12.4f} %\n", curve.scene, curve.technique,
                       curve.isOnPlanes ? "planes" : "others", point.lixelsUsed, point.count.samples,
                       point.count.samples > 0 ? 100 * double(point.count.misclassified) / double(point.count.samples)
                                               : 0.0);
}

} // namespace

int studyPlaneBudget(const StudyOptions& options)
{
    const Sizes& sizes = options.isQuick ? kQuickSizes : kSizes;
    const std::size_t most = std::size_t(options.count > 0 ? options.count : options.isQuick ? kQuickViews : 1 << 20);
    std::vector<Shooting> shootings;
    int shots = 0;
    for (const char* scene : kScenes) {
        PictureOptions picture;
        picture.scene = scene;
        picture.size = sizes.picture;
        Shooting& shooting = shootings.emplace_back(prepare(picture, true));
        if (shooting.shots.size() > most) shooting.shots.resize(most);
        shots += int(shooting.shots.size());
    }
    std::vector<std::unique_ptr<Executor>> executors;
    executors.push_back(makeExecutor(options.executor));

    PlaneBudget study;
    study.isQuick = options.isQuick;
    for (const Study& known : studies())
        if (known.name == "plane-budget") study.question = known.question;
    study.run.seed = options.seed;
    const Stopwatch total;
    {
        Progress progress("study plane-budget", shots * int(2 * sizes.sides.size() + 1));
        for (const Shooting& shooting : shootings)
            for (const Shot& shot : shooting.shots)
                for (ResultRow& row : rowsOfShot(shooting, shot, sizes.sides, executors, progress)) {
                    row.seed = options.seed;
                    study.run.rows.push_back(std::move(row));
                }
    }
    finishResults(study.run, options.commandLine, total.seconds(), executors.front()->host());
    makeCurves(sizes.sides, study);
    return finishStudyOfRows(study, options, print);
}

} // namespace lixel::app
