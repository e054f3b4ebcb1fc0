// SPDX-License-Identifier: MIT
// What deciding costs: planShadows for one light, by technique, kind of light and number of caster boxes. Techniques made from
// view samples are timed apart, by the number of samples.
#include "lixel/plan/fit/plane_optimal.h"
#include "lixel/plan/shadow_plan.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace lixel;

// A floor with boxes of one unit on it, as a city's blocks; one box is the floor alone.
std::vector<Box> blocks(int count)
{
    const int side = int(std::ceil(std::sqrt(double(count))));
    std::vector<Box> boxes{{Vec3d(-side, -1, -side), Vec3d(side, 0, side)}};
    for (int i = 1; i < count; ++i) {
        const double x = 2 * (i % side) - side, z = 2.0 * (i / side) - side;
        boxes.push_back({Vec3d(x, 0, z), Vec3d(x + 1, 1, z + 1)});
    }
    return boxes;
}

Light lightOf(LightKind kind, double extent)
{
    Light light;
    light.kind = kind;
    light.positionWorld = {0, extent, 0};
    light.directionWorld = kind == LightKind::Directional ? normalized({0.4, -1, 0.3}) : Vec3d{0, -1, 0};
    return light;
}

View viewOf(double extent)
{
    return perspectiveView({0.3, 1.7, 0.9 * extent}, {0, 1, 0}, {0, 1, 0}, std::numbers::pi / 3, 0.1, 4 * extent, 1024,
                           1024);
}

// What a camera at eye level sees of the floor.
ViewSamples floorSamples(const View& view, double extent, int count)
{
    ViewSamples samples;
    samples.width = view.width;
    samples.height = view.height;
    const int side = int(std::sqrt(double(count)));
    for (int i = 0; i < side * side; ++i) {
        const double x = extent * (2.0 * (i % side) / side - 1),
                     depth = 0.8 * extent * std::pow(double(i / side + 1) / side, 2);
        samples.positionLocal.push_back({float(x * depth / extent), 0, float(0.9 * extent - 2 - depth)});
        samples.normal.push_back({0, 1, 0});
        samples.pixel.push_back({0.5f, 0.5f});
        samples.triangle.push_back(kNoTriangle);
    }
    return samples;
}

void plan(benchmark::State& state, const std::string& technique, LightKind kind, int boxCount, int sampleCount)
{
    const std::vector<Box> boxes = blocks(boxCount);
    const double extent = std::max(10.0, std::sqrt(double(boxCount)));
    const std::vector<Light> lights{lightOf(kind, extent)};
    PlanInput input;
    input.view = viewOf(extent);
    input.lights = lights;
    input.casterBoxesWorld = boxes;
    input.technique = std::get<MapTechnique>(*parseTechnique(technique));
    input.lixels = {512, 512};
    const ViewSamples samples = floorSamples(input.view, extent, sampleCount);
    if (sampleCount > 0) input.seen = &samples;
    // The floor, and a wall across its far end.
    const std::vector<NamedPlane> planes{{"floor", {0, 0, 0}, {0, 1, 0}, {}},
                                         {"wall", {0, 0, -0.5 * extent}, {0, 0, 1}, {}}};
    input.planes = planes;
    FitScratch scratch;
    FramePlan plan;
    for (auto _ : state) {
        plan = planShadows(input, scratch, std::move(plan));
        benchmark::DoNotOptimize(plan.regionTable.data());
    }
    if (plan.lights[0].refused) state.SkipWithError(std::string(nameOf(*plan.lights[0].refused)).c_str());
    state.counters["regions"] = double(plan.regionTable.size());
}

// The matrix of one plane alone, without what its map holds.
void planeMatrix(benchmark::State& state, LightKind kind)
{
    const View view = viewOf(10);
    const Light light = lightOf(kind, 10);
    Plane plane{{0, 1, 0}, 0};
    for (auto _ : state) {
        benchmark::DoNotOptimize(plane);
        benchmark::DoNotOptimize(planeOptimalFrame(view, light, {}, plane, 30));
    }
}
BENCHMARK_CAPTURE(planeMatrix, sun, LightKind::Directional);
BENCHMARK_CAPTURE(planeMatrix, spot, LightKind::Spot);
BENCHMARK_CAPTURE(planeMatrix, point, LightKind::Point);

const bool registered = [] {
    const struct
    {
        LightKind kind;
        const char* name;
    } kinds[] = {{LightKind::Directional, "sun"}, {LightKind::Spot, "spot"}, {LightKind::Point, "point"}};
    for (const char* technique :
         {"uniform", "focused", "focused(stable)", "minimal-frustum", "psm", "psm(shift=none)", "tsm", "lispsm",
          "lispsm(stable)", "pssm(4)", "pssm(4)+lispsm", "cube", "planes(floor)+plane-optimal(uncovered=lit)",
          "planes(floor,wall)", "planes(floor,wall)+allocation=exact"})
        for (const auto& [kind, kindName] : kinds)
            for (const int boxes : {1, 100, 10000})
                benchmark::RegisterBenchmark(
                    (std::string(technique) + "/" + kindName + "/boxes:" + std::to_string(boxes)).c_str(), plan,
                    technique, kind, boxes, 0)
                    ->Unit(benchmark::kMicrosecond);
    for (const char* technique : {"desired-view", "desired-view(rotated)", "sdsm(4)", "lispsm", "scene-optimal",
                                  "planes(floor,wall)", "planes(auto)"})
        for (const int samples : {1024, 32400, 1048576})
            benchmark::RegisterBenchmark(
                (std::string(technique) + "/sun/boxes:100/samples:" + std::to_string(samples)).c_str(), plan, technique,
                LightKind::Directional, 100, samples)
                ->Unit(benchmark::kMicrosecond);
    return true;
}();

} // namespace
