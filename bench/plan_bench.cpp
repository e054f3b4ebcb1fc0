// SPDX-License-Identifier: MIT
// What deciding costs: planShadows for one light and a grid of caster boxes, by fit and kind of light.
#include "lixel/plan/shadow_plan.h"

#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

namespace {

using namespace lixel;

// A floor of side 2 `half` with boxes of one unit on it, as a city's blocks.
std::vector<Box> blocks(int half)
{
    std::vector<Box> boxes;
    for (int z = -half; z < half; z += 2)
        for (int x = -half; x < half; x += 2) boxes.push_back({Vec3d(x, 0, z), Vec3d(x + 1, 1, z + 1)});
    return boxes;
}

Light lightOf(LightKind kind)
{
    Light light;
    light.kind = kind;
    light.positionWorld = {0, 60, 0};
    light.directionWorld = kind == LightKind::Directional ? normalized({0.4, -1, 0.3}) : Vec3d{0, -1, 0};
    return light;
}

void planOneLight(benchmark::State& state, const FitChoice& fit, LightKind kind)
{
    const std::vector<Box> boxes = blocks(int(state.range(0)));
    const std::vector<Light> lights{lightOf(kind)};
    PlanInput input;
    input.view = perspectiveView({0, 3, 20}, {0, 0, 0}, {0, 1, 0}, std::numbers::pi / 3, 0.1, 100, 1024, 1024);
    input.lights = lights;
    input.casterBoxesWorld = boxes;
    input.technique.fit = fit;
    input.lixels = {512, 512};
    FitScratch scratch;
    FramePlan plan;
    for (auto _ : state) {
        plan = planShadows(input, scratch, std::move(plan));
        benchmark::DoNotOptimize(plan.regionTable.data());
    }
    state.counters["boxes"] = double(boxes.size());
}

BENCHMARK_CAPTURE(planOneLight, uniform_directional, UniformFit{}, LightKind::Directional)->Arg(4)->Arg(32);
BENCHMARK_CAPTURE(planOneLight, focused_directional, FocusedFit{}, LightKind::Directional)->Arg(4)->Arg(32);
BENCHMARK_CAPTURE(planOneLight, focused_spot, FocusedFit{}, LightKind::Spot)->Arg(4)->Arg(32);
BENCHMARK_CAPTURE(planOneLight, focused_point, FocusedFit{}, LightKind::Point)->Arg(4)->Arg(32);

} // namespace
