// SPDX-License-Identifier: MIT
#include "comparison.h"
#include "experiment.h"
#include "lixel/judge/ranked_sums.h"
#include "lixel/scene/framing.h"
#include "lixel/scene/hemisphere_lights.h"
#include "run_results.h"

#include <array>

#include <fmt/format.h>

// Chong and Gortler 2007, section 3: a few dozen objects on a floor, the viewer slightly above it, 500 lights uniform on a
// distant hemisphere, picture 750x750, maps 400x400. Our truth is exact visibility, theirs a focused map of 4000x4000.
namespace lixel::app {
namespace {

constexpr const char* kView = "among";
constexpr const char* kPicture = "750x750";
constexpr const char* kMap = "400x400";
constexpr const char* kTechniques = "focused,uniform"; // numbered so:
enum Method : std::size_t { Focused, Normal };

// Table 1: misclassified pixels, sums over 500 images.
constexpr double kPaperLights = 500, kPaperPixels = 750 * 750;
constexpr double kPaperFocused = 2407686, kPaperNormal = 5405579;
constexpr double kPaperFocusedInWorstOfFocused = 485088, kPaperNormalInWorstOfFocused = 1203575;
constexpr double kPaperFocusedInWorstOfNormal = 448302, kPaperNormalInWorstOfNormal = 1308651;

} // namespace

Reproduction reproduceNormalAgainstFocused(const ExperimentOptions& options)
{
    const int count = options.lights.value_or(options.isQuick ? 50 : 500);
    const std::string lixels = options.lixels.value_or(kMap);
    PictureOptions pictureOptions;
    pictureOptions.scene = "objects";
    pictureOptions.view = kView;
    pictureOptions.size = options.size.value_or(kPicture);
    Shooting shooting = prepare(pictureOptions, false);
    Shot& shot = shooting.shots.front();
    const Stage stage =
        makeStage(shooting.scene, shooting.evaluateOptions, chooseOrigin(shot.camera.eyeWorld, shooting.sceneWorld));
    const View view = makeView(shot.camera, shooting.width, shooting.height, shooting.sceneWorld);
    std::vector<std::unique_ptr<Executor>> executors;
    executors.push_back(makeExecutor(options.executor));
    ComparisonOptions comparison;
    comparison.techniques = readTechniques(kTechniques);
    comparison.lixels.total = readSize(lixels, "--lixels", kMostLixelsASide);
    comparison.timingFrames = 0;

    Reproduction out;
    std::array<std::vector<double>, 2> errors; // [method][light]
    Progress progress("reproduce", count);
    for (const Light& light : hemisphereLights(options.seed, count)) {
        progress.step(light.name);
        shot.lights = {light};
        for (ResultRow& row :
             compareShot(shooting, shot, stage, view, executors, comparison, [](std::string_view) {})) {
            row.seed = options.seed;
            if (const Measurement* m = row.measured())
                errors[row.technique == "focused" ? Focused : Normal].push_back(double(m->misclassified));
            out.run.rows.push_back(std::move(row));
        }
    }
    const RankedSums sums = rankedSums(errors, 0.1);
    const auto ratio = [](const std::vector<double>& of) { return of[Normal] / of[Focused]; };
    const double pixels = double(shooting.width) * shooting.height;
    out.run.timing.host = executors.front()->host();
    out.parameters = {{"scene", pictureOptions.scene},
                      {"view", kView},
                      {"lights", fmt::format("{}", count)},
                      {"size", pictureOptions.size},
                      {"lixels", lixels},
                      {"executor", options.executor},
                      {"seed", fmt::format("{}", options.seed)}};
    out.numbers = {
        {"normal over focused, all lights", "ratio", ratio(sums.all), kPaperNormal / kPaperFocused,
         "Table 1, using all data"},
        {"normal over focused, worst tenth by focused", "ratio", ratio(sums.worst[Focused]),
         kPaperNormalInWorstOfFocused / kPaperFocusedInWorstOfFocused, "Table 1, worst 10 %, row Foc"},
        {"normal over focused, worst tenth by normal", "ratio", ratio(sums.worst[Normal]),
         kPaperNormalInWorstOfNormal / kPaperFocusedInWorstOfNormal, "Table 1, worst 10 %, row Normal"},
        {"focused, misclassified of the picture", "percent", 100 * sums.all[Focused] / count / pixels,
         100 * kPaperFocused / kPaperLights / kPaperPixels, "Table 1, using all data"},
        {"normal, misclassified of the picture", "percent", 100 * sums.all[Normal] / count / pixels,
         100 * kPaperNormal / kPaperLights / kPaperPixels, "Table 1, using all data"},
    };
    return out;
}

} // namespace lixel::app
