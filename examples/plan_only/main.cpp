// SPDX-License-Identifier: MIT
//
// What an engine asks of lixel::plan each frame, and what it does with the answer. This engine draws as Vulkan does: depth
// reversed in 0..1, an infinite far plane, y down, row 0 of a texture at its top. Nothing here touches a graphics API.
#include <lixel/plan/footprint.h>
#include <lixel/plan/host_matrix.h>
#include <lixel/plan/host_region.h>
#include <lixel/plan/host_view.h>
#include <lixel/plan/shadow_plan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace lixel;

namespace {

constexpr ClipConvention kVulkan{ClipDepth::OneToZero, true};
constexpr TextureOrigin kOrigin = TextureOrigin::Top;
constexpr int kWidth = 1920, kHeight = 1080;

// As the engine's own maths library makes it, and keeps it: 16 floats, column after column. Depth is near / distance.
std::array<float, 16> engineProjection(float fovy, float near)
{
    const float focal = 1 / std::tan(fovy / 2);
    std::array<float, 16> columns{};
    columns[0] = focal * kHeight / kWidth;
    columns[5] = -focal; // y down
    columns[11] = -1;    // w = distance ahead
    columns[14] = near;
    return columns;
}

// The camera stands at (3, 1.7, 8) and looks along -z. In double where the engine has it: worlds may be large.
Mat4d engineViewFromWorld() { return translation({-3, -1.7, -8}); }

std::vector<Light> engineLights()
{
    Light sun;
    sun.name = "sun";
    sun.directionWorld = normalized({-0.4, -1, -0.3});

    Light bulb; // right in the scene: one map cannot hold what it sees
    bulb.name = "bulb";
    bulb.kind = LightKind::Point;
    bulb.positionWorld = {0, 2.5, 0};
    bulb.range = 12;

    std::vector<Light> lights{sun, bulb};
    for (int i = 0; i < 20; ++i) { // a street of lamps; those behind the camera light nothing that it sees
        Light lamp;
        lamp.name = "lamp " + std::to_string(i);
        lamp.kind = LightKind::Spot;
        lamp.positionWorld = {i % 2 ? 6.0 : -6.0, 5, 16.0 - 4 * (i / 2)};
        lamp.directionWorld = {0, -1, 0};
        lamp.coneAngle = 1.4;
        lamp.range = 9;
        lights.push_back(lamp);
    }
    return lights;
}

// Bounds of all that casts or receives, one box a mesh, in world space.
std::vector<Box> engineBoxes()
{
    std::vector<Box> boxes{{{-40, -0.1, -40}, {40, 0, 40}}};
    for (int i = 0; i < 9; ++i) {
        const double x = -6 + 6 * (i % 3), z = -8 + 6 * (i / 3);
        boxes.push_back({{x - 0.5, 0, z - 0.5}, {x + 0.5, 1.5 + 0.3 * i, z + 0.5}});
    }
    return boxes;
}

void printMatrix(const char* name, const Mat4d& m)
{
    for (int i = 0; i < 4; ++i)
        std::printf("    %-18s %12.6f %12.6f %12.6f %12.6f\n", i ? "" : name, m.m[i][0], m.m[i][1], m.m[i][2],
                    m.m[i][3]);
}

// What the engine binds to draw a region's casters: a layer, a viewport, a matrix; depth clamp on, depth bias off.
void printRegion(const HostRegion& region, bool withMatrix)
{
    const LixelRectangle& v = region.viewport;
    std::printf("    layer %d, viewport x %d, y %d, %d x %d\n", v.layer, v.x0, v.y0, v.width(), v.height());
    if (withMatrix) printMatrix("clipFromLocal", region.clipFromLocal);
}

// Where a point of the world lies in the atlas, by way of the matrix with which the engine draws and the one with which it
// reads; false where they do not meet, or miss what lixel itself says.
bool checkPoint(const FramePlan& plan, const View& view, std::size_t light, Vec3d pointWorld)
{
    const Vec3d pointLocal = pointWorld - plan.originWorld;
    for (const PlannedRegion& region : plan.lights[light].regions) {
        // The first region that holds the point and has it on its map serves it.
        const auto holds = [&](const Plane& plane) { return plane.signedDistance(pointLocal) >= 0; };
        const LightImage image(region.projection(), region.rectangle, &region.warp);
        const std::optional<Vec3d> lixel = image.lixelAt(pointLocal);
        if (!lixel || !std::all_of(region.halfSpacesLocal.begin(), region.halfSpacesLocal.end(), holds)) continue;
        const HostRegion host = toHost(region, plan.atlas, kVulkan, kOrigin);
        const LixelRectangle& v = host.viewport;

        const Vec3d ndc = project(host.clipFromLocal, pointLocal);
        const Vec2d drawn{v.x0 + (0.5 + 0.5 * ndc.x) * v.width(), v.y0 + (0.5 + 0.5 * ndc.y) * v.height()};
        const Vec3d read = project(host.textureFromLocal, pointLocal);
        const Vec2d expected = toHost(Vec2d{lixel->x, lixel->y}, plan.atlas, kOrigin);
        std::printf("    (%g, %g, %g) is at texel (%.3f, %.3f) of layer %d, u %.5f, v %.5f, depth %.6f\n", pointWorld.x,
                    pointWorld.y, pointWorld.z, drawn.x, drawn.y, v.layer, read.x, read.y, read.z);

        // No bias to choose: the receiver's plane says what depth changes over a lixel. lixel_lookup.glsl does this.
        if (const auto f = footprint(view, plan.originWorld, image, pointLocal, {0, 1, 0}))
            std::printf("    there a lixel is %.2f pixels long, the floor's depth changes by %.2e and %.2e a lixel\n",
                        f->pixelsPerLixel, 0.5 * std::abs(f->depthPerLixel.x), 0.5 * std::abs(f->depthPerLixel.y));

        const double texelU = read.x * plan.atlas.width, texelV = read.y * plan.atlas.height;
        return std::abs(drawn.x - expected.x) < 1e-6 && std::abs(drawn.y - expected.y) < 1e-6 &&
               std::abs(texelU - expected.x) < 1e-6 && std::abs(texelV - expected.y) < 1e-6 &&
               std::abs(ndc.z - read.z) < 1e-9;
    }
    std::printf("    (%g, %g, %g) is in no region: nothing there can be lit and seen\n", pointWorld.x, pointWorld.y,
                pointWorld.z);
    return true;
}

} // namespace

int main(int argc, char** argv)
{
    const std::string text = argc > 1 ? argv[1] : "cube+focused+pcf(9)";
    const auto technique = parseTechnique(text);
    const MapTechnique* maps = technique ? std::get_if<MapTechnique>(&*technique) : nullptr;
    if (!maps || needsViewSamples(*maps)) {
        std::fprintf(stderr, "%s\n",
                     technique ? "this example has techniques with maps, made from bounds alone"
                               : technique.error().c_str());
        return 2;
    }

    // The camera enters, in the engine's convention.
    const std::array<float, 16> projection = engineProjection(1.0f, 0.1f);
    const auto view = viewFromHost(matrixFromColumns(std::span<const float, 16>(projection)), engineViewFromWorld(),
                                   kVulkan, kWidth, kHeight);
    if (!view) return 1;

    // The plan. In an engine `scratch` and `plan` live on: a frame like the last one then allocates nothing.
    const std::vector<Light> lights = engineLights();
    const std::vector<Box> boxes = engineBoxes();
    FitScratch scratch;
    FramePlan plan;
    for (int frame = 0; frame < 2; ++frame)
        plan = planShadows({.view = *view,
                            .lights = lights,
                            .casterBoxesWorld = boxes,
                            .originWorld = view->anchorWorld, // all floats are relative to it
                            .technique = *maps,
                            .lixels = {512, 512}}, // the budget of each light
                           scratch, std::move(plan));

    // The matrices leave, in the engine's convention.
    std::printf("%s\natlas: %d layers of %d x %d lixels of %d bytes\n", toString(*technique).c_str(), plan.layers,
                plan.atlas.width, plan.atlas.height, plan.lookup.bytesPerLixel);
    bool isRight = true;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const ShadowPlan& shadow = plan.lights[i];
        if (shadow.refused) {
            std::printf("%s: no map, %s\n", lights[i].name.c_str(), std::string(sentenceFor(*shadow.refused)).c_str());
            continue;
        }
        std::printf("%s: %zu regions\n", lights[i].name.c_str(), shadow.regions.size());
        for (const PlannedRegion& region : shadow.regions)
            printRegion(toHost(region, plan.atlas, kVulkan, kOrigin), i < 2);
        const Vec3d spot = lights[i].kind == LightKind::Spot ? lights[i].positionWorld : Vec3d{2, 0, 2};
        isRight = checkPoint(plan, *view, i, {spot.x, 0, spot.z}) && isRight;
    }
    std::printf(isRight ? "all points agree\n" : "points do not agree\n");
    return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
