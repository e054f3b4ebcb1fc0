// SPDX-License-Identifier: MIT
// Exact visibility against an independent method on view samples of every scene there is:
// built-in, and all files of the scene folder. Half of the samples lie within 2 pixels of a shadow boundary. Some
// 20,000 samples in all, a million when thorough.
#include "lixel/scene/builtin.h"
#include "lixel/scene/evaluate.h"
#include "lixel/scene/framing.h"
#include "lixel/scene/load.h"
#include "lixel/trace/exact_visibility.h"
#include "lixel/trace/trace_view_samples.h"

#include "support/random_cases.h"
#include "support/scene_files.h"
#include "trace/reference_visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>

namespace lixel {
namespace {

using namespace lixel::test;

constexpr std::size_t kMostTrianglesInAHurry = 500000;
constexpr int kMostShots = 60;

// Two methods that round otherwise can only differ where a ray passes an edge this near, as a share of its way.
constexpr double kTie = 1e-12;

std::vector<std::string> allScenes()
{
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtinScenes()) names.emplace_back(scene.name);
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(sceneFolder(), missing))
        if (entry.path().extension() == ".glb") names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::size_t samplesPerScene()
{
    const std::size_t scenes = allScenes().size();
    return ((isThorough() ? 1000000 : 20000) + scenes - 1) / scenes;
}

struct Shot
{
    View view;
    Light light;
};

// The scene's own views in turn; beyond them, or without, any camera about the scene and any light in or around it.
Shot shotOf(const Scene& scene, const Box& boxWorld, int number, int pixels, Rng& rng)
{
    if (std::size_t(number) < scene.views.size()) {
        const NamedView& view = scene.views[std::size_t(number)];
        const Light light = view.lights.empty() ? defaultSun() : view.lights[std::size_t(number) % view.lights.size()];
        return {makeView(view.camera, pixels, pixels, boxWorld), light};
    }
    const Vec3d size = boxWorld.max - boxWorld.min, centre = boxWorld.centre();
    const auto within = [&](double share) {
        return centre + Vec3d{size.x * rng.uniform(-share, share), size.y * rng.uniform(-share, share),
                              size.z * rng.uniform(-share, share)};
    };
    Camera camera = defaultCamera(boxWorld, 1);
    if (number % 3 != 0) camera.eyeWorld = within(number % 3 == 1 ? 0.45 : 1.5), camera.targetWorld = within(0.3);
    Light light = defaultSun();
    if (number % 2 != 0) {
        light.kind = rng.chance(0.5) ? LightKind::Point : LightKind::Directional;
        light.directionWorld = rng.onSphere();
        light.positionWorld = within(rng.chance(0.5) ? 0.45 : 2);
    }
    return {makeView(camera, pixels, pixels, boxWorld), light};
}

bool isFacing(const ViewSamples& samples, std::size_t i, const Light& light)
{
    return isLightFacing(light, samples.originWorld, toDouble(samples.positionLocal[i]), toDouble(samples.normal[i]));
}

// Pixels within 2 of a point halfway between 4-neighbours of which one is lit and the other in shadow.
Image<std::uint8_t> nearBoundary(const ViewSamples& samples, const Light& light, const std::vector<float>& exact)
{
    const int n = samples.width;
    Image<std::int8_t> state(n, n, -1);
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (isFacing(samples, i, light)) state(int(samples.pixel[i].x), int(samples.pixel[i].y)) = exact[i] > 0 ? 1 : 0;
    Image<std::uint8_t> near(n, n, 0);
    const auto mark = [&](double atX, double atY) {
        for (int y = std::max(0, int(atY) - 2); y <= std::min(n - 1, int(atY) + 3); ++y)
            for (int x = std::max(0, int(atX) - 2); x <= std::min(n - 1, int(atX) + 3); ++x)
                if ((x - atX) * (x - atX) + (y - atY) * (y - atY) <= 4) near(x, y) = 1;
    };
    const auto differ = [](int a, int b) { return a >= 0 && b >= 0 && a != b; };
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            if (x + 1 < n && differ(state(x, y), state(x + 1, y))) mark(x + 0.5, y);
            if (y + 1 < n && differ(state(x, y), state(x, y + 1))) mark(x, y + 0.5);
        }
    }
    return near;
}

// Up to `most` light-facing samples for each of: away from boundaries, near them.
std::array<std::vector<std::size_t>, 2> choose(const ViewSamples& samples, const Light& light,
                                               const std::vector<float>& exact, std::array<std::size_t, 2> most,
                                               Rng& rng)
{
    const Image<std::uint8_t> near = nearBoundary(samples, light, exact);
    std::array<std::vector<std::size_t>, 2> chosen;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (isFacing(samples, i, light)) chosen[near(int(samples.pixel[i].x), int(samples.pixel[i].y))].push_back(i);
    for (std::size_t k = 0; k < 2; ++k) {
        most[k] = std::min(most[k], chosen[k].size());
        for (std::size_t i = 0; i < most[k]; ++i)
            std::swap(chosen[k][i], chosen[k][i + rng.bits() % (chosen[k].size() - i)]);
        chosen[k].resize(most[k]);
    }
    return chosen;
}

struct Counts
{
    std::array<std::size_t, 2> samples{}, disagreements{}; // away from boundaries, near them
    std::size_t grazing = 0, changedByRules = 0, unexplained = 0;
};

std::vector<ReferenceAnswer> answersTo(const ReferenceScene& reference, const ViewSamples& samples, const Light& light,
                                       const std::vector<std::size_t>& chosen)
{
    std::vector<ReferenceAnswer> answers(chosen.size());
    const std::size_t threads = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::jthread> workers;
    for (std::size_t t = 0; t < threads; ++t)
        workers.emplace_back([&, t] {
            for (std::size_t k = t; k < chosen.size(); k += threads)
                answers[k] = reference.visibility(samples, chosen[k], light);
        });
    workers.clear();
    return answers;
}

void compare(const ReferenceScene& reference, const ViewSamples& samples, const Light& light,
             const std::vector<float>& exact, const std::vector<std::size_t>& chosen, std::size_t kind, Counts& counts)
{
    const std::vector<ReferenceAnswer> answers = answersTo(reference, samples, light, chosen);
    counts.samples[kind] += chosen.size();
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        const std::size_t i = chosen[k];
        counts.grazing += answers[k].isGrazing;
        counts.changedByRules += answers[k].isLit != answers[k].isLitByBareGeometry;
        if (answers[k].isLit == (exact[i] > 0)) continue;
        ++counts.disagreements[kind];
        const double tie = reference.nearestEdge(samples, i, light);
        counts.unexplained += !(tie < kTie);
        const Vec3f p = samples.positionLocal[i];
        std::printf("  differs %s boundaries: pixel (%g, %g), triangle %u at %.9g %.9g %.9g: exact %g, reference %s "
                    "(triangle %u)%s; "
                    "its ray passes an edge at %.3g of its way%s\n",
                    kind ? "near" : "AWAY FROM", samples.pixel[i].x, samples.pixel[i].y, samples.triangle[i], p.x, p.y,
                    p.z, exact[i], answers[k].isLit ? "lit" : "dark", answers[k].blocker,
                    answers[k].isGrazing ? ", grazing" : "", tie, tie < kTie ? ": a tie" : ": UNEXPLAINED");
    }
}

class CrossCheck : public testing::TestWithParam<std::string>
{
};

TEST_P(CrossCheck, TwoIndependentMethodsAgreeOnViewSamples)
{
    const std::string name = GetParam();
    const bool isFile = name.find('.') != std::string::npos;
    const auto scene =
        std::make_shared<const Scene>(isFile ? loadScene((sceneFolder() / name).string()) : buildBuiltin(name).value());
    const EvaluateOptions options{0.5, 0};
    const Box boxWorld = sceneBounds(*scene, options);
    const SceneBuffers buffers =
        evaluate(scene, options, chooseOrigin(boxWorld.centre() + Vec3d{0.1, 0.2, 0.3}, boxWorld));
    if (!isThorough() && buffers.triangles.triangleCount() > kMostTrianglesInAHurry)
        GTEST_SKIP() << "more than " << kMostTrianglesInAHurry << " triangles: only with LIXEL_THOROUGH=1";
    const TraceScene traced(buffers.casters());
    const ReferenceScene reference(traced.triangles(), scene->materials, scene->textures);

    // A sixth of the samples at most from one shot.
    const std::size_t half = samplesPerScene() / 2 + 1;
    Rng rng(20040621);
    Counts counts;
    for (int number = 0; number < kMostShots && counts.samples[0] + counts.samples[1] < 2 * half; ++number) {
        const Shot shot = shotOf(*scene, boxWorld, number, isThorough() ? 512 : 160, rng);
        const ViewSamples samples = traceViewSamples(traced, shot.view);
        const std::vector<float> exact = exactVisibility(traced, samples, shot.light);
        const auto most = [&](std::size_t k) { return std::min(half / 6 + 1, half - counts.samples[k]); };
        const auto chosen = choose(samples, shot.light, exact, {most(0), most(1)}, rng);
        for (std::size_t k = 0; k < 2; ++k) compare(reference, samples, shot.light, exact, chosen[k], k, counts);
    }
    std::printf("%s: %zu samples away from boundaries, %zu differ; %zu near, %zu differ; %zu grazing; %zu decided by "
                "the rules for "
                "rounded corners\n",
                name.c_str(), counts.samples[0], counts.disagreements[0], counts.samples[1], counts.disagreements[1],
                counts.grazing, counts.changedByRules);
    EXPECT_EQ(counts.disagreements[0], 0u);
    EXPECT_LT(double(counts.disagreements[1]), std::max(1.0, 1e-5 * double(counts.samples[1])));
    EXPECT_EQ(counts.unexplained, 0u);
    EXPECT_GE(counts.samples[0] + counts.samples[1], samplesPerScene());
    EXPECT_GE(counts.samples[1], samplesPerScene() / 2);
}

std::string asIdentifier(const testing::TestParamInfo<std::string>& info)
{
    std::string name = info.param.substr(0, info.param.find('.'));
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, CrossCheck, testing::ValuesIn(allScenes()), asIdentifier);

} // namespace
} // namespace lixel
