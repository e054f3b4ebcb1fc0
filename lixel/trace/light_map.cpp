// SPDX-License-Identifier: MIT
#include "lixel/trace/light_map.h"

#include "lixel/base/assert.h"
#include "lixel/plan/clip_convention.h"
#include "lixel/trace/parallel.h"
#include "lixel/trace/ray_triangle.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lixel {
namespace {

// Lixels are traced in tiles of 4 x 4, whose rays walk through the tree together.
constexpr int kTile = 4;
constexpr std::size_t kTileLixels = kTile * kTile;

bool keepsAlpha(const void* scene, std::uint32_t triangle, float u, float v)
{
    return static_cast<const TraceScene*>(scene)->keeps(triangle, u, v);
}

class RegionTracer
{
public:
    RegionTracer(const TraceScene& scene, const PlannedRegion& region)
        : scene_(scene),
          projection_(region.projection()),
          image_(projection_, region.rectangle, &region.warp),
          depthFromLocal_(toHost(region.lightClipFromLocal, kExecutorConvention)),
          rectangle_(region.rectangle)
    {
    }

    // Slower than tiles, and in double from the ray on.
    float exactDepth(int x, int y) const
    {
        const std::optional<LightRay> lightRay = image_.rayThrough({x + 0.5, y + 0.5});
        if (!lightRay) return 0;
        const Interval inScene = beforeLight(*lightRay);
        Nearest nearest{scene_, {lightRay->originLocal, lightRay->directionLocal, inScene.first, {}}, inScene.last};
        const auto meets = [](void* query, std::uint32_t triangle) {
            return static_cast<Nearest*>(query)->meet(triangle);
        };
        scene_.embree().offerUpToNearest(searchRay(nearest.ray.origin, nearest.ray.direction, inScene), meets,
                                         &nearest);
        return nearest.isMet ? depthAt(nearest.ray.origin + nearest.t * nearest.ray.direction) : 0;
    }

    void traceTile(int x0, int y0, Image<float>& layer) const
    {
        std::array<LightRay, kTileLixels> rays;
        std::array<Interval, kTileLixels> inScene;
        std::array<SearchRay, kTileLixels> search;
        std::array<SearchHit, kTileLixels> hits;
        for (std::size_t i = 0; i < kTileLixels; ++i) {
            const int x = x0 + int(i % kTile), y = y0 + int(i / kTile);
            const bool isOwned = x < rectangle_.x1 && y < rectangle_.y1;
            const std::optional<LightRay> ray = isOwned ? image_.rayThrough({x + 0.5, y + 0.5}) : std::nullopt;
            rays[i] = ray.value_or(LightRay{});
            inScene[i] = ray ? beforeLight(*ray) : Interval{0, -1};
            search[i] = searchRay(rays[i].originLocal, rays[i].directionLocal, inScene[i]);
        }
        scene_.embree().nearest(search, hits, keepsAlpha, &scene_);
        for (std::size_t i = 0; i < kTileLixels; ++i) {
            const int x = x0 + int(i % kTile), y = y0 + int(i / kTile);
            if (x >= rectangle_.x1 || y >= rectangle_.y1) continue;
            layer(x, y) = hits[i].triangle == kNoTriangle ? 0.0f : depthOf(hits[i], rays[i], inScene[i].first);
        }
    }

private:
    // The state of one walk through the tree.
    struct Nearest
    {
        const TraceScene& scene;
        Ray ray;
        double t; // of the ray: up to here nothing else was met
        bool isMet = false;

        // In lengths from the start of the search.
        std::optional<double> meet(std::uint32_t triangle)
        {
            const std::optional<TriangleHit> hit = intersect(ray, scene.corners(triangle));
            if (!hit || !(hit->t <= t) || !scene.keeps(triangle, float(hit->u), float(hit->v))) return std::nullopt;
            t = hit->t;
            isMet = true;
            return (t - ray.tMin) * length(ray.direction);
        }
    };

    // The part of the ray's line that is lit: within the scene, from the light on, which is where w is 0 or infinitely
    // far, and where rays of paraboloids begin.
    Interval beforeLight(const LightRay& ray) const
    {
        Interval lit{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
        if (projection_.paraboloid) {
            lit.first = 0;
            return clipToBox(ray.originLocal, ray.directionLocal, scene_.searchBoxLocal(), lit);
        }
        const double w = (depthFromLocal_ * point(ray.originLocal)).w;
        const double wAlong = (depthFromLocal_ * direction(ray.directionLocal)).w;
        if (wAlong > 0) lit.first = -w / wAlong;
        else if (wAlong < 0) lit.last = -w / wAlong;
        else if (!(w > 0)) return {0, -1};
        return clipToBox(ray.originLocal, ray.directionLocal, scene_.searchBoxLocal(), lit);
    }

    // Found in floats, a triangle may be missed by a little in double; its plane goes on, but its depths do not.
    float depthOf(const SearchHit& hit, const LightRay& ray, double start) const
    {
        const Corners corners = scene_.corners(hit.triangle);
        const double searched = start + double(hit.t) / length(ray.directionLocal);
        const double t = meetPlane(ray.originLocal, ray.directionLocal, corners).value_or(searched);
        const Vec3d onPlane = ray.originLocal + t * ray.directionLocal;
        return depthAt(drawnInto(corners, onPlane, 0).value_or(onPlane));
    }

    float depthAt(Vec3d pointLocal) const
    {
        if (projection_.paraboloid) {
            const auto ndc = projection_.ndcAt(pointLocal);
            return ndc ? float(std::clamp(0.5 - 0.5 * ndc->z, 0.0, 1.0)) : 1.0f;
        }
        const Vec4d clip = depthFromLocal_ * point(pointLocal);
        return clip.w > 0 ? float(std::clamp(clip.z / clip.w, 0.0, 1.0)) : 1.0f;
    }

    const TraceScene& scene_;
    LightProjection projection_;
    LightImage image_;
    Mat4d depthFromLocal_;
    LixelRectangle rectangle_;
};

} // namespace

void traceLightMap(const TraceScene& scene, const PlannedRegion& region, Image<float>& layer)
{
    const LixelRectangle& r = region.rectangle;
    LX_ASSERT(r.x0 >= 0 && r.y0 >= 0 && r.x1 <= layer.width() && r.y1 <= layer.height());
    const RegionTracer tracer(scene, region);
    if (region.pixels) {
        forEachBlock(std::size_t(r.height()), 4, [&](std::size_t first, std::size_t last) {
            for (std::size_t row = first; row < last; ++row)
                for (int x = r.x0; x < r.x1; ++x) layer(x, r.y0 + int(row)) = tracer.exactDepth(x, r.y0 + int(row));
        });
        return;
    }
    const std::size_t tileRows = std::size_t(r.height() + kTile - 1) / kTile;
    forEachBlock(tileRows, 4, [&](std::size_t first, std::size_t last) {
        for (std::size_t row = first; row < last; ++row)
            for (int x = r.x0; x < r.x1; x += kTile) tracer.traceTile(x, r.y0 + int(row) * kTile, layer);
    });
}

float tracedDepth(const TraceScene& scene, const PlannedRegion& region, int x, int y)
{
    return RegionTracer(scene, region).exactDepth(x, y);
}

} // namespace lixel
