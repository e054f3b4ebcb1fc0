// SPDX-License-Identifier: MIT
// Frames like those before allocate nothing in plan. This program counts what operator new is asked for.
#include "lixel/plan/partition/find_planes.h"
#include "lixel/plan/shadow_plan.h"
#include "plan/ordinary_setups.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t size)
{
    ++allocations;
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}

} // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace lixel {
namespace {

class NoAllocation : public testing::TestWithParam<const char*>
{
};

// A few receivers on the floor before the camera.
ViewSamples floorSamples(const test::RandomSetup& setup, test::Rng& rng)
{
    ViewSamples samples;
    samples.width = setup.view.width;
    samples.height = setup.view.height;
    samples.originWorld = setup.originWorld;
    for (int i = 0; i < 100; ++i) {
        const Vec3d p = setup.view.anchorWorld + setup.radius * rng.inBox(1) - setup.originWorld;
        samples.pixel.push_back({});
        samples.positionLocal.push_back({float(p.x), 0, float(p.z)});
        samples.normal.push_back({0, 1, 0});
        samples.triangle.push_back(kNoTriangle);
    }
    return samples;
}

TEST_P(NoAllocation, FramesThatWerePlannedBeforeAllocateNothing)
{
    test::Rng rng(20040621);
    std::vector<test::RandomSetup> setups;
    std::vector<ViewSamples> seen;
    for (int i = 0; i < 60; ++i) {
        setups.push_back(test::ordinarySetup(rng));
        seen.push_back(floorSamples(setups.back(), rng));
    }
    const std::vector<NamedPlane> planes{{"floor", {0, 0, 0}, {0, 1, 0}, {}}, {"wall", {0, 0, -10}, {0, 0, 1}, {}}};
    FitScratch scratch;
    FramePlan plan;
    PlanInput input;
    input.technique = std::get<MapTechnique>(*parseTechnique(GetParam()));
    input.lixels = {512, 512};
    const auto planAll = [&] {
        for (std::size_t i = 0; i < setups.size(); ++i) {
            input.view = setups[i].view;
            input.lights = {&setups[i].light, 1};
            input.casterBoxesWorld = setups[i].boxesWorld;
            input.originWorld = setups[i].originWorld;
            input.seen = &seen[i];
            input.planes = planes;
            plan = planShadows(input, scratch, std::move(plan));
        }
    };
    planAll();
    const long before = allocations;
    planAll();
    EXPECT_EQ(allocations - before, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Techniques, NoAllocation,
    testing::Values("uniform", "focused", "focused(stable)", "desired-view", "desired-view(rotated)", "minimal-frustum",
                    "psm", "psm(shift=none)", "tsm", "lispsm", "lispsm(stable)", "scene-optimal",
                    "scene-optimal(metric=l2,search=paper)", "pssm(3)+scene-optimal", "pssm(4)+lispsm",
                    "pssm(4,stable)", "sdsm(4)", "sdsm(4,stable)", "cube", "psm+else(cube)", "dual-paraboloid",
                    "dual-paraboloid+desired-view+now(grid=64)", "planes(floor,wall)",
                    "planes(floor,wall)+allocation=exact", "planes(floor,wall)+plane-optimal(desired-view)",
                    "planes(auto)", "rtw", "now", "cube+lispsm+now(smooth=1/8,grid=64)",
                    "desired-view+now(importance=count*max(edges,normal)*distance)"));

TEST(NoAllocation, PlanesAreSoughtInTheSameRoomAgain)
{
    test::Rng rng(20040621);
    PlaneScratch scratch;
    FoundPlanes found;
    const auto seek = [&](std::size_t count) {
        std::vector<Vec3d> points, normals;
        for (std::size_t i = 0; i < count; ++i) {
            const int side = rng.integer(0, 3);
            const Vec3d p = rng.inBox(1);
            points.push_back(side == 0 ? Vec3d{p.x, 0, p.z} : side == 1 ? Vec3d{p.x, p.y, 0} : p);
            normals.push_back(side == 0 ? Vec3d{0, 1, 0} : side == 1 ? Vec3d{0, 0, 1} : rng.onSphere());
        }
        const long before = allocations;
        findPlanes({points, normals, {}, {0, 0, 0, 1e-3}}, scratch, found);
        return allocations - before;
    };
    seek(10); // the first call makes all the room, however short its list
    for (const std::size_t count : {3000u, 40000u, 5u, 5000u}) EXPECT_EQ(seek(count), 0);
    EXPECT_EQ(found.size(), 2u);
}

} // namespace
} // namespace lixel
