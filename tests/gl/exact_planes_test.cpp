// SPDX-License-Identifier: MIT
// On a floor whose lixels are its pixels: what the rasterizer gets wrong is at edges and contacts.
#include "graphics.h"
#include "shadow_drawer.h"

#include "lixel/gl/executor.h"
#include "lixel/judge/on_planes.h"
#include "lixel/plan/technique.h"
#include "lixel/trace/exact_visibility.h"
#include "lixel/trace/plane_probe.h"

#include <array>
#include <cstdio>

namespace lixel::test {
namespace {

class ExactPlanesTest : public GlTest
{
};

TEST_F(ExactPlanesTest, ErrorsOfTheRasterizerAreFewAndEachIsNextToAnEdgeOrAContact)
{
    GlExecutor executor;
    const auto technique =
        std::get<MapTechnique>(parseTechnique("planes(floor)+plane-optimal+else(cube)+allocation=exact").value());
    const std::array<NamedPlane, 1> planes{NamedPlane{"floor", {}, {0, 1, 0}, {}}};
    std::size_t counted = 0, shadowed = 0, wrong = 0;
    PlaneErrorCauses causes;
    forEachCase(30, [&](Rng& rng) {
        const SmallScene scene = anyObjectsOnAFloor(rng, 1);
        const View view = anyViewOf(rng, {}, 1, 200, 160);
        const Light light = anyLightOn(rng, {}, 1);
        const CasterBuffers casters = scene.casters();
        const ViewSamples samples = executor.viewSamples(casters, view);
        const Box box = scene.boxWorld();
        PlanInput input{view, {&light, 1}, {&box, 1}, scene.originWorld, technique, {800, 800}};
        input.planes = planes;
        input.seen = &samples;
        input.seenIsAll = true;
        const FramePlan plan = planShadows(input);
        const bool hasFloor = !plan.lights[0].refused && plan.lights[0].regions.front().plane == 0;
        if (!hasFloor) return; // seen from below, or not at all
        const TraceScene traced(casters);
        const std::vector<float> exact = exactVisibility(traced, samples, light);
        const std::vector<Visibility> drawn = executor.run(plan, casters, samples);
        const std::vector<int> plane = planeOfSamples(samples, planes);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Vec3d p = toDouble(samples.positionLocal[i]), n = toDouble(samples.normal[i]);
            if (plane[i] != 0 || !isLightFacing(light, {}, p, n)) continue;
            ++counted;
            shadowed += exact[i] < 0.5f;
            if (drawn[0].value[i] == exact[i]) continue;
            ++wrong;
            const PlaneProbe probe = probeOnPlane(traced, plan, 0, 0, light, samples, i, kBesideLixels);
            causes.add(causeOfPlaneError(exact[i], probe.exactBeside, probe.isNearCaster));
        }
    });
    std::printf("%zu of %zu wrong: %lld near edges, %lld near casters\n", wrong, counted,
                static_cast<long long>(causes.nearEdge), static_cast<long long>(causes.nearCaster));
    EXPECT_GT(counted, 100000u);
    EXPECT_GT(shadowed, 5000u);
    EXPECT_LE(double(wrong), 2e-4 * double(counted));
    EXPECT_EQ(causes.unexplained, 0);
}

} // namespace
} // namespace lixel::test
