// SPDX-License-Identifier: MIT
#include "lixel/report/one_to_one.h"

#include "executor.h"
#include "exit_code.h"
#include "lixel/gl/graphics_error.h"
#include "lixel/plan/fit/plane_optimal.h"
#include "lixel/plan/light_image.h"
#include "lixel/plan/region_table.h"
#include "output.h"
#include "progress.h"
#include "run_results.h"
#include "studies/random_plane.h"
#include "study.h"

#if LIXEL_HAS_GL
#include "lixel/gl/executor.h"
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <thread>

#include <fmt/format.h>

// The proof of "A Lixel for every Pixel": random views and lights over a plane, and how far the lixel that samples a point of the plane is from
// the pixel that sees it; by the fit's own matrix in double, and by what the device's depth pass has drawn.
namespace lixel::app {
namespace {

constexpr int kCount = 10000, kQuickCount = 1000, kPointsADouble = 200;

// The map of a configuration at a lixel a pixel.
struct PixelMap
{
    Fit fit;
    PixelRectangle pixels;
};

Expected<PixelMap, FitFailure> mapOf(const PlaneConfiguration& c, FitScratch& scratch)
{
    Box sceneLocal;
    for (const Vec3f& p : c.triangleLocal) sceneLocal.include(toDouble(p));
    const Box sceneWorld = translated(sceneLocal, c.originWorld);
    FitInput input{c.view, c.light, c.originWorld, {&sceneWorld, 1}, sceneLocal, scratch};
    input.plane = PlaneOfCell{c.planeLocal, Twist::None, {}};
    input.wantsWholePixels = true;
    const FitResult fit = fitPlaneOptimal(input, {});
    if (!fit) return Unexpected{fit.error()};
    return PixelMap{*fit, *fit->pixels};
}

double apart(Vec2d lixel, const PixelRectangle& pixels, const PlaneConfiguration& c, Vec3d pointLocal)
{
    const Vec3d pixel = pixelFromLocal(c.view, c.originWorld, pointLocal);
    return std::max(std::abs(lixel.x + pixels.x0 - pixel.x), std::abs(lixel.y + pixels.y0 - pixel.y));
}

// The farthest of some points of the plane that the map holds, by the fit's matrix; negative where there is none.
double worstInDouble(const PlaneConfiguration& c, const PixelMap& map, std::int64_t& points)
{
    const int width = map.pixels.width(), height = map.pixels.height();
    const LightImage image(map.fit.lightClipFromLocal, {0, 0, width, height, 0});
    const std::int64_t lixels = std::int64_t(width) * height;
    const std::int64_t step = std::max<std::int64_t>(1, lixels / kPointsADouble) | 1;
    double worst = -1;
    for (std::int64_t i = 0; i < lixels; i += step) {
        const std::int64_t column = i % width, row = i / width;
        const Vec2d pixel{map.pixels.x0 + double(column) + 0.5, map.pixels.y0 + double(row) + 0.5};
        const auto p = seenAt(c.view, c.originWorld, c.planeLocal, pixel);
        const auto lixel = p ? image.lixelAt(*p) : std::nullopt;
        if (!lixel || lixel->z > 1) continue;
        worst = std::max(worst, apart({lixel->x, lixel->y}, map.pixels, c, *p));
        ++points;
    }
    return worst;
}

#if LIXEL_HAS_GL
FramePlan planOf(const PlaneConfiguration& c, const PixelMap& map)
{
    FramePlan plan;
    plan.atlas = {map.pixels.width(), map.pixels.height()};
    plan.layers = 1;
    plan.originWorld = c.originWorld;
    PlannedRegion region;
    region.lightClipFromLocal = map.fit.lightClipFromLocal;
    region.rectangle = {0, 0, map.pixels.width(), map.pixels.height(), 0};
    region.isInDouble = needsDouble(map.fit, map.pixels.width(), map.pixels.height());
    plan.regionTable = {tableRow(region)};
    plan.lightTable = {{{0, 1, 1, 0}}};
    plan.lights.emplace_back().regions.push_back(region);
    return plan;
}

// The farthest of the lixels that the device has drawn; negative where there is none.
double worstOnDevice(const PlaneConfiguration& c, const PixelMap& map, GlExecutor& executor, std::int64_t& points)
{
    CasterBuffers casters;
    casters.originWorld = c.originWorld;
    CasterMesh mesh;
    mesh.positions = c.triangleLocal;
    casters.meshes.push_back(mesh);
    const Image<Vec4f> drawn = std::move(executor.drawPositions(planOf(c, map), casters)[0]);
    double worst = -1;
    for (int y = 0; y < drawn.height(); ++y)
        for (int x = 0; x < drawn.width(); ++x) {
            const Vec4f p = drawn(x, y);
            if (!(p.w > 0)) continue;
            worst = std::max(worst, apart({x + 0.5, y + 0.5}, map.pixels, c, {p.x, p.y, p.z}));
            ++points;
        }
    return worst;
}
#endif

std::string_view nameOf(LightKind kind)
{
    constexpr std::array<std::string_view, 3> kNames{"directional", "spot", "point"};
    return kNames[std::size_t(kind)];
}

void add(double worst, const PlaneConfiguration& c, OneToOne::Deviations& deviations,
         std::optional<OneToOne::Worst>& worstOfAll)
{
    if (worst < 0) return;
    deviations.worstPixels.push_back(worst);
    if (!worstOfAll || worst > worstOfAll->deviationPixels)
        worstOfAll = {c.parameters, std::string(nameOf(c.light.kind)), worst};
}

std::string numberOrDash(const std::vector<double>& values)
{
    return values.empty() ? "-" : fmt::format("{:.2e} pixel", *std::max_element(values.begin(), values.end()));
}

} // namespace

int studyOneToOne(const StudyOptions& options)
{
    OneToOne study;
    study.seed = options.seed;
    study.configurations = options.count > 0 ? options.count : options.isQuick ? kQuickCount : kCount;
    study.whyNotOnDevice = "--executor trace draws nothing";
    study.timing.host = fmt::format("{} processors", std::thread::hardware_concurrency());
#if LIXEL_HAS_GL
    std::unique_ptr<GlExecutor> executor;
    if (options.executor == "gl") {
        try {
            executor = std::make_unique<GlExecutor>();
            study.onDevice = OneToOne::Deviations{};
            study.timing.host = executor->renderer() + ", " + study.timing.host;
        } catch (const gl::GraphicsError& error) {
            study.whyNotOnDevice = error.what();
        }
    }
#else
    if (options.executor == "gl") study.whyNotOnDevice = "this lixel was built without OpenGL";
#endif
    const Stopwatch total;
    FitScratch scratch;
    Progress progress("study one-to-one", study.configurations);
    for (int i = 0; i < study.configurations; ++i) {
        progress.step("");
        const PlaneConfiguration c = randomPlane(options.seed, i);
        const auto map = mapOf(c, scratch);
        if (!map) {
            ++study.refused[std::string(lixel::nameOf(map.error()))];
            continue;
        }
        add(worstInDouble(c, *map, study.inDouble.points), c, study.inDouble, study.worstInDouble);
#if LIXEL_HAS_GL
        if (executor)
            add(worstOnDevice(c, *map, *executor, study.onDevice->points), c, *study.onDevice, study.worstOnDevice);
#endif
    }
    study.lixelVersion = LIXEL_VERSION;
    study.command = options.commandLine;
    study.timing = timingNow(total.seconds(), study.timing.host);
    if (!options.json.empty()) writeOrPrint(options.json, toJson(study));
    std::FILE* to = options.json == "-" ? stderr : stdout;
    fmt::print(to, "farthest lixel from its pixel: {} in double, {} on the device ({})\n",
               numberOrDash(study.inDouble.worstPixels),
               study.onDevice ? numberOrDash(study.onDevice->worstPixels) : "-",
               study.onDevice ? study.timing.host : study.whyNotOnDevice);
    return kDone;
}

} // namespace lixel::app
