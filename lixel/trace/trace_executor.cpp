// SPDX-License-Identifier: MIT
#include "lixel/trace/trace_executor.h"

#include "lixel/base/assert.h"
#include "lixel/shared/lookup/visibility.h"
#include "lixel/trace/light_map.h"
#include "lixel/trace/parallel.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace lixel {
namespace {

shared::vec3 toShared(Vec3f a) { return {a.x, a.y, a.z}; }

bool isWithinHalfSpaces(const FramePlan& plan, const shared::ShadowRegion& region, shared::vec3 positionLocal)
{
    const std::span<const shared::vec4> all = plan.halfSpaceTable;
    for (const shared::vec4& h : all.subspan(std::size_t(region.place.y), std::size_t(region.place.z)))
        if (!shared::lxHolds(h, positionLocal)) return false;
    return true;
}

// What lookups read, as the shared functions ask for it.
template <typename Knots>
struct Maps
{
    const TracedAtlas& atlas;
    const PreparedMaps& prepared;
    const Knots& knots;

    float depth(int x, int y, int layer) const { return atlas[std::size_t(layer)](x, y); }
    shared::LxWords words(int x, int y, int layer) const { return prepared.words[std::size_t(layer)](x, y); }
    std::uint32_t gradient(int x, int y, int layer) const { return prepared.gradients[std::size_t(layer)](x, y); }
    shared::vec4 moments(int x, int y, int layer) const { return prepared.moments[std::size_t(layer)](x, y); }

    // What a texture unit does, in floats.
    float hardwareLit(shared::vec2 lixel, int layer, float reference) const
    {
        const Image<float>& map = atlas[std::size_t(layer)];
        const float x = std::floor(lixel.x - 0.5f), y = std::floor(lixel.y - 0.5f);
        const float right = lixel.x - 0.5f - x, above = lixel.y - 0.5f - y;
        const auto lit = [&](int i, int j) {
            const int column = std::clamp(int(x) + i, 0, map.width() - 1);
            return map(column, std::clamp(int(y) + j, 0, map.height() - 1)) <= reference ? 1.0f : 0.0f;
        };
        return (1 - above) * ((1 - right) * lit(0, 0) + right * lit(1, 0)) +
               above * ((1 - right) * lit(0, 1) + right * lit(1, 1));
    }
};

} // namespace

TracedAtlas traceAtlas(const TraceScene& scene, const FramePlan& plan)
{
    LX_ASSERT(scene.originWorld() == plan.originWorld);
    TracedAtlas atlas(std::size_t(plan.layers), Image<float>(plan.atlas.width, plan.atlas.height));
    for (const ShadowPlan& light : plan.lights)
        for (const PlannedRegion& region : light.regions)
            traceLightMap(scene, region, atlas[std::size_t(region.rectangle.layer)]);
    return atlas;
}

Visibility lookUp(const FramePlan& plan, const TracedAtlas& atlas, const PreparedMaps& prepared,
                  const ViewSamples& samples, std::size_t light)
{
    LX_ASSERT(samples.originWorld == plan.originWorld && light < plan.lightTable.size());
    const auto warpKnot = [&](int i) { return plan.warpTable[std::size_t(i)]; };
    const Maps<decltype(warpKnot)> maps{atlas, prepared, warpKnot};
    const shared::vec4 served = plan.lightTable[light].regions;
    const std::span<const shared::ShadowRegion> allRegions = plan.regionTable;
    const std::span<const shared::ShadowRegion> regions =
        allRegions.subspan(std::size_t(served.x), std::size_t(served.y));
    Visibility visibility{std::vector<float>(samples.size(), 1.0f), std::vector<std::uint8_t>(samples.size(), 1)};
    forEachBlock(samples.size(), 4096, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const shared::vec3 positionLocal = toShared(samples.positionLocal[i]);
            for (const shared::ShadowRegion& region : regions) {
                if (!isWithinHalfSpaces(plan, region, positionLocal)) continue;
                shared::LxReceiver receiver =
                    shared::lxReceive(region, positionLocal, toShared(samples.normal[i]), warpKnot);
                if (receiver.isInside == 0) continue;
                if (receiver.isOnPlane != 0) receiver.margin = 0; // rays need no room for a rasterizer's grid
                visibility.value[i] =
                    shared::lxVisibility(plan.lookup.how, region, receiver, shared::lxSeedOf(positionLocal), maps);
                visibility.unserved[i] = 0;
                break;
            }
        }
    });
    return visibility;
}

std::vector<Visibility> runTraced(const TraceScene& scene, const FramePlan& plan, const ViewSamples& samples)
{
    const TracedAtlas atlas = traceAtlas(scene, plan);
    const PreparedMaps prepared = prepareMaps(plan, atlas);
    std::vector<Visibility> visibility;
    for (std::size_t light = 0; light < plan.lights.size(); ++light)
        visibility.push_back(lookUp(plan, atlas, prepared, samples, light));
    return visibility;
}

} // namespace lixel
