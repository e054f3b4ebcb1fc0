// SPDX-License-Identifier: MIT
#include "lixel/trace/prepared_maps.h"

#include "lixel/shared/lookup/blur.h"
#include "lixel/shared/lookup/gradient.h"
#include "lixel/shared/lookup/select_depths.h"
#include "lixel/trace/parallel.h"

namespace lixel {
namespace {

// The map itself, as the shared functions ask for it.
struct BaseMaps
{
    const TracedAtlas& atlas;
    float depth(int x, int y, int layer) const { return atlas[std::size_t(layer)](x, y); }
};

// Moments after the first of the two passes of a blur.
struct HalfBlurred
{
    const Image<shared::vec4>& image;
    shared::vec4 moments(int x, int y, int) const { return image(x, y); }
};

template <typename T>
std::vector<Image<T>> layersOf(const FramePlan& plan, bool isWanted)
{
    if (!isWanted) return {};
    return std::vector<Image<T>>(std::size_t(plan.layers), Image<T>(plan.atlas.width, plan.atlas.height));
}

template <typename Set>
void forEachLixel(const LixelRectangle& r, const Set& set)
{
    forEachBlock(std::size_t(r.height()), 16, [&](std::size_t first, std::size_t last) {
        for (std::size_t row = first; row < last; ++row)
            for (int x = r.x0; x < r.x1; ++x) set(x, r.y0 + int(row));
    });
}

} // namespace

PreparedMaps prepareMaps(const FramePlan& plan, const TracedAtlas& atlas)
{
    const LookupLayout& lookup = plan.lookup;
    PreparedMaps out{layersOf<shared::LxWords>(plan, lookup.preparedWords > 0),
                     layersOf<std::uint32_t>(plan, lookup.hasGradients),
                     layersOf<shared::vec4>(plan, lookup.momentChannels > 0)};
    std::vector<Image<shared::vec4>> across = out.moments;
    const BaseMaps maps{atlas};
    for (std::size_t i = 0; i < plan.regionTable.size(); ++i) {
        const shared::vec4 r = plan.regionTable[i].rectangle;
        const float bend = plan.regionTable[i].projection.z;
        const LixelRectangle rectangle{int(r.x), int(r.y), int(r.z), int(r.w), int(plan.regionTable[i].place.x)};
        const int layer = rectangle.layer;
        const auto at = std::size_t(layer);
        if (lookup.preparedWords > 0)
            forEachLixel(rectangle, [&](int x, int y) {
                out.words[at](x, y) = shared::lxPackedDepths(lookup.how, r, bend, x, y, layer, maps);
            });
        if (lookup.hasGradients)
            forEachLixel(rectangle, [&](int x, int y) {
                out.gradients[at](x, y) = shared::lxPackedGradient(shared::lxGradient(r, x, y, layer, maps));
            });
        if (lookup.momentChannels == 0) continue;
        forEachLixel(rectangle, [&](int x, int y) {
            across[at](x, y) = shared::lxMomentsAcross(lookup.how, r, bend, x, y, layer, maps);
        });
        forEachLixel(rectangle, [&](int x, int y) {
            out.moments[at](x, y) = shared::lxMomentsAlong(lookup.how, r, x, y, layer, HalfBlurred{across[at]});
        });
    }
    return out;
}

} // namespace lixel
