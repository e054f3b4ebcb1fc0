// SPDX-License-Identifier: MIT
#include "comparison.h"
#include "experiment.h"
#include "lixel/scene/framing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <fmt/format.h>

// Chong and Gortler 2007, section 5: a few dozen objects on a floor, the viewer slightly above it, 500 lights uniform on a
// distant hemisphere, picture 750x750, maps 400x400. Our truth is exact visibility, theirs a focused map of 4000x4000.
namespace lixel::app {
namespace {

constexpr const char* kView = "among";
constexpr LixelSize kPicture{750, 750}, kMap{400, 400};

// Table 1: misclassified pixels, sums over 500 images.
constexpr double kPaperLights = 500;
constexpr double kPaperFocused = 2407686, kPaperNormal = 5405579;
constexpr double kPaperFocusedInWorstOfFocused = 485088, kPaperNormalInWorstOfFocused = 1203575;
constexpr double kPaperFocusedInWorstOfNormal = 448302, kPaperNormalInWorstOfNormal = 1308651;

// Suns from uniform places on the upper hemisphere.
std::vector<Light> hemisphereLights(std::uint64_t seed, int count)
{
    std::mt19937_64 engine(seed);
    const auto unit = [&engine] { return double(engine() >> 11) * 0x1p-53; };
    std::vector<Light> lights;
    for (int i = 0; i < count; ++i) {
        const double y = unit(), angle = 2 * std::numbers::pi * unit(), r = std::sqrt(1 - y * y);
        Light light;
        light.name = fmt::format("sun-{:03}", i);
        light.directionWorld = {-r * std::cos(angle), -y, -r * std::sin(angle)};
        lights.push_back(light);
    }
    return lights;
}

// Misclassified samples of each light.
struct Errors
{
    std::vector<double> focused, normal;
};

// The ratio of sums over the tenth of the lights that is worst by `by`.
double worstTenthRatio(const Errors& errors, const std::vector<double>& by)
{
    std::vector<std::size_t> order(by.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return by[a] > by[b]; });
    double focused = 0, normal = 0;
    for (std::size_t i = 0; i < std::max<std::size_t>(order.size() / 10, 1); ++i)
        focused += errors.focused[order[i]], normal += errors.normal[order[i]];
    return normal / focused;
}

} // namespace

Reproduction reproduceNormalAgainstFocused(const ExperimentOptions& options)
{
    const int count = options.isQuick ? 50 : 500;
    PictureOptions pictureOptions;
    pictureOptions.scene = "objects";
    pictureOptions.view = kView;
    pictureOptions.size = fmt::format("{}x{}", kPicture.width, kPicture.height);
    Shooting shooting = prepare(pictureOptions, false);
    Shot& shot = shooting.shots.front();
    const Stage stage =
        makeStage(shooting.scene, shooting.evaluateOptions, chooseOrigin(shot.camera.eyeWorld, shooting.sceneWorld));
    const View view = makeView(shot.camera, shooting.width, shooting.height, shooting.sceneWorld);
    std::vector<std::unique_ptr<Executor>> executors;
    executors.push_back(makeExecutor(options.executor));
    ComparisonOptions comparison;
    comparison.techniques = readTechniques("uniform,focused");
    comparison.lixels.total = kMap;
    comparison.timingFrames = 0;

    Reproduction out;
    Errors errors;
    Progress progress("reproduce", count);
    for (const Light& light : hemisphereLights(options.seed, count)) {
        progress.step(light.name);
        shot.lights = {light};
        for (ResultRow& row :
             compareShot(shooting, shot, stage, view, executors, comparison, [](std::string_view) {})) {
            row.seed = options.seed;
            if (const Measurement* m = row.measured())
                (row.technique == "focused" ? errors.focused : errors.normal).push_back(double(m->misclassified));
            out.run.rows.push_back(std::move(row));
        }
    }
    const double focused = std::accumulate(errors.focused.begin(), errors.focused.end(), 0.0);
    const double normal = std::accumulate(errors.normal.begin(), errors.normal.end(), 0.0);
    const double pixels = double(kPicture.width) * kPicture.height;
    out.run.timing.host = executors.front()->host();
    out.parameters = {{"scene", pictureOptions.scene},
                      {"view", kView},
                      {"lights", fmt::format("{}", count)},
                      {"size", pictureOptions.size},
                      {"lixels", fmt::format("{}x{}", kMap.width, kMap.height)},
                      {"executor", options.executor},
                      {"seed", fmt::format("{}", options.seed)}};
    out.numbers = {
        {"normal over focused, all lights", "ratio", normal / focused, kPaperNormal / kPaperFocused,
         "Table 1, using all data"},
        {"normal over focused, worst tenth by focused", "ratio", worstTenthRatio(errors, errors.focused),
         kPaperNormalInWorstOfFocused / kPaperFocusedInWorstOfFocused, "Table 1, worst 10 %, row Foc"},
        {"normal over focused, worst tenth by normal", "ratio", worstTenthRatio(errors, errors.normal),
         kPaperNormalInWorstOfNormal / kPaperFocusedInWorstOfNormal, "Table 1, worst 10 %, row Normal"},
        {"focused, misclassified of the picture", "percent", 100 * focused / count / pixels,
         100 * kPaperFocused / kPaperLights / pixels, "Table 1, using all data"},
        {"normal, misclassified of the picture", "percent", 100 * normal / count / pixels,
         100 * kPaperNormal / kPaperLights / pixels, "Table 1, using all data"},
    };
    return out;
}

} // namespace lixel::app
