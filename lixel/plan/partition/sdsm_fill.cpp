// SPDX-License-Identifier: MIT
#include "lixel/plan/partition/sdsm_fill.h"

#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/visible_body.h"
#include "lixel/plan/shading_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lixel {
namespace {

using shared::SdsmBounds;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A device loops over them: more than these are taken as one.
constexpr std::size_t kMostCasters = 4096;

shared::vec4 toShared(Vec3d v, double w) { return {float(v.x), float(v.y), float(v.z), float(w)}; }
shared::vec4 toShared(Vec4d v) { return {float(v.x), float(v.y), float(v.z), float(v.w)}; }
shared::vec3 toShared(Vec3f v) { return {v.x, v.y, v.z}; }

// The count of cascades, if this is the one technique that has such a layout.
std::optional<int> cascadesOf(const MapTechnique& technique)
{
    const SdsmPartition* partition = std::get_if<SdsmPartition>(&technique.partition);
    const DesiredViewFit* fit = std::get_if<DesiredViewFit>(&technique.fit);
    if (!partition || !fit || fit->isRotated || technique.isStable || technique.otherwise) return std::nullopt;
    return partition->count;
}

// Regions with their rectangles, each but the last with a half-space, that hold no point.
std::optional<FramePlan> emptyPlan(const PlanInput& input, std::size_t count)
{
    std::vector<double> shares(count, 1.0 / double(count));
    std::vector<LixelRectangle> rectangles(count);
    if (!cutRectangle({0, 0, input.lixels.width, input.lixels.height, 0}, shares, rectangles)) return std::nullopt;
    GivenLight given;
    for (std::size_t i = 0; i < count; ++i) {
        GivenRegion& region = given.regions.emplace_back();
        region.lightClipFromWorld = Mat4d::fromRows({}, {}, {}, {0, 0, 0, -1});
        region.rectangle = rectangles[i];
        if (i + 1 < count) region.halfSpacesWorld.push_back({});
    }
    PlanInput empty = input;
    empty.technique.partition = WholePartition{};
    empty.technique.fit = MatrixFit{};
    empty.given = {&given, 1};
    return planShadows(empty);
}

std::vector<shared::SdsmCasters> castersOnPlane(const PlanInput& input, const LightFrame& frame)
{
    std::vector<shared::SdsmCasters> casters;
    const std::array<Vec4d, 3> rows{frame.framedFromLocal.row(0), frame.framedFromLocal.row(1),
                                    frame.framedFromLocal.row(2)};
    for (const Box& boxWorld : input.casterBoxesWorld) {
        if (boxWorld.isEmpty()) continue;
        Box onPlane; // x, y, and depth
        for (const Vec3d& corner : translated(boxWorld, -input.originWorld).corners())
            onPlane.include(
                Vec3d{dot(rows[0], point(corner)), dot(rows[1], point(corner)), dot(rows[2], point(corner))});
        casters.push_back({{float(onPlane.min.x), float(onPlane.min.y), float(onPlane.max.x), float(onPlane.max.y)},
                           {float(onPlane.min.z), 0, 0, 0}});
    }
    if (casters.size() <= kMostCasters) return casters;
    shared::SdsmCasters all = casters[0];
    for (const shared::SdsmCasters& c : casters) {
        all.onPlane = {std::min(all.onPlane.x, c.onPlane.x), std::min(all.onPlane.y, c.onPlane.y),
                       std::max(all.onPlane.z, c.onPlane.z), std::max(all.onPlane.w, c.onPlane.w)};
        all.depth.x = std::min(all.depth.x, c.depth.x);
    }
    return {all};
}

SdsmFill fillOf(const PlanInput& input, const FramePlan& plan, std::size_t light)
{
    const LightFrame frame = lightFrame(input.lights[light], input.originWorld, {});
    const ViewDepth depth = viewDepth(input.view, input.originWorld);
    const shared::vec4& regions = plan.lightTable[light].regions;
    SdsmFill fill;
    fill.casters = castersOnPlane(input, frame);
    fill.setup.light = shadingLight(input.lights[light], input.originWorld);
    fill.setup.viewDepth = toShared(depth.forward, depth.offset);
    fill.setup.lightX = toShared(frame.framedFromLocal.row(0));
    fill.setup.lightY = toShared(frame.framedFromLocal.row(1));
    fill.setup.lightDepth = toShared(frame.framedFromLocal.row(2));
    fill.setup.regions = {regions.x, regions.y, plan.regionTable[std::size_t(regions.x)].place.y,
                          float(plan.lookup.reach)};
    fill.setup.options = {depth.isPerspective ? 1.0f : 0.0f, float(fill.casters.size()), 0, 0};
    return fill;
}

struct Facing
{
    std::vector<shared::vec3> positionLocal;
    std::vector<float> depth;
    float nearest = kInfinity, farthest = -kInfinity;
};

Facing facingSamples(const shared::SdsmSetup& setup, const ViewSamples& samples)
{
    Facing facing;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const shared::vec3 p = toShared(samples.positionLocal[i]);
        if (!shared::lxFaces(setup.light, p, toShared(samples.normal[i]))) continue;
        const float depth = shared::lxSdsmAt(setup.viewDepth, p);
        facing.positionLocal.push_back(p);
        facing.depth.push_back(depth);
        facing.nearest = std::min(facing.nearest, depth);
        facing.farthest = std::max(facing.farthest, depth);
    }
    return facing;
}

std::optional<SdsmBounds> boundsOf(const shared::SdsmSetup& setup, const Facing& facing, int cascade)
{
    SdsmBounds bounds{{kInfinity, kInfinity, -kInfinity, -kInfinity}, -kInfinity, 0, 0};
    const float begin = shared::lxSdsmSplit(setup, facing.nearest, facing.farthest, cascade);
    const float end = shared::lxSdsmSplit(setup, facing.nearest, facing.farthest, cascade + 1);
    for (std::size_t i = 0; i < facing.depth.size(); ++i) {
        if (!shared::lxSdsmHolds(setup, cascade, begin, end, facing.depth[i])) continue;
        const shared::vec3 p = facing.positionLocal[i];
        const float x = shared::lxSdsmAt(setup.lightX, p), y = shared::lxSdsmAt(setup.lightY, p);
        bounds.onPlane = {std::min(bounds.onPlane.x, x), std::min(bounds.onPlane.y, y), std::max(bounds.onPlane.z, x),
                          std::max(bounds.onPlane.w, y)};
        bounds.farthest = std::max(bounds.farthest, shared::lxSdsmAt(setup.lightDepth, p));
        bounds.termsX = std::max(bounds.termsX, shared::lxSdsmTerms(setup.lightX, p));
        bounds.termsY = std::max(bounds.termsY, shared::lxSdsmTerms(setup.lightY, p));
    }
    if (!(bounds.onPlane.x <= bounds.onPlane.z)) return std::nullopt;
    return bounds;
}

// From the executors' convention back to lixel's.
Mat4d toDouble(const shared::mat4& m)
{
    const auto row = [&](float shared::vec4::*of) { return Vec4d{m[0].*of, m[1].*of, m[2].*of, m[3].*of}; };
    const Vec4d w = row(&shared::vec4::w);
    return Mat4d::fromRows(row(&shared::vec4::x), row(&shared::vec4::y), w - 2.0 * row(&shared::vec4::z), w);
}

} // namespace

std::optional<SdsmLayout> layoutSdsm(const PlanInput& input)
{
    const std::optional<int> count = cascadesOf(input.technique);
    const bool areParallel = std::all_of(input.lights.begin(), input.lights.end(),
                                         [](const Light& light) { return light.kind == LightKind::Directional; });
    if (!count || !areParallel) return std::nullopt;
    std::optional<FramePlan> plan = emptyPlan(input, std::size_t(*count));
    if (!plan) return std::nullopt;
    SdsmLayout layout{std::move(*plan), {}};
    for (std::size_t i = 0; i < input.lights.size(); ++i) layout.fills.push_back(fillOf(input, layout.plan, i));
    return layout;
}

void fillSdsm(const SdsmFill& fill, const ViewSamples& samples, FramePlan& plan)
{
    const shared::SdsmSetup& setup = fill.setup;
    const auto first = std::size_t(setup.regions.x), count = std::size_t(setup.regions.y);
    const auto firstHalfSpace = std::size_t(setup.regions.z);
    const auto light = std::find_if(plan.lightTable.begin(), plan.lightTable.end(),
                                    [&](const shared::ShadowLight& row) { return row.regions.x == setup.regions.x; });
    LX_ASSERT(light != plan.lightTable.end());
    std::vector<PlannedRegion>& regions = plan.lights[std::size_t(light - plan.lightTable.begin())].regions;

    const Facing facing = facingSamples(setup, samples);
    for (std::size_t i = 0; i < count; ++i) {
        shared::ShadowRegion& row = plan.regionTable[first + i];
        row.lightClipFromLocal = shared::lxSdsmNowhere();
        if (const auto bounds = boundsOf(setup, facing, int(i))) {
            float nearest = kInfinity;
            for (const shared::SdsmCasters& box : fill.casters)
                if (shared::lxSdsmMeets(box, *bounds)) nearest = std::min(nearest, box.depth.x);
            row.lightClipFromLocal = shared::lxSdsmMatrix(setup, *bounds, nearest, row.rectangle);
        }
        regions[i].lightClipFromLocal = toDouble(row.lightClipFromLocal);
        if (i + 1 == count) continue;
        const shared::vec4 h = facing.depth.empty()
                                   ? shared::vec4(0, 0, 0, -1)
                                   : shared::lxSdsmHalfSpace(setup, facing.nearest, facing.farthest, int(i));
        plan.halfSpaceTable[firstHalfSpace + i] = h;
        regions[i].halfSpacesLocal.clear();
        regions[i].halfSpacesLocal.push_back({{h.x, h.y, h.z}, h.w});
    }
}

} // namespace lixel
