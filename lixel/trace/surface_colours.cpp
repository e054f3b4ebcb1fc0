// SPDX-License-Identifier: MIT
#include "lixel/trace/surface_colours.h"

#include "lixel/base/assert.h"
#include "lixel/trace/parallel.h"
#include "lixel/trace/surface_point.h"
#include "lixel/trace/texture_lookup.h"

#include <array>

namespace lixel {
namespace {

using Weights = std::array<double, 3>;

struct Colours
{
    Vec3f base, emission, normal;
};

Weights weightsOf(const Corners& c, Vec3d p)
{
    const Vec3d n = cross(c[1] - c[0], c[2] - c[0]);
    const double squared = dot(n, n);
    if (!(squared > 0)) return {1, 0, 0};
    const double u = dot(n, cross(p - c[0], c[2] - c[0])) / squared, v = dot(n, cross(c[1] - c[0], p - c[0])) / squared;
    return {1 - u - v, u, v};
}

template <typename Value>
double blended(const Weights& w, const std::array<std::uint32_t, 3>& at, Value value)
{
    return w[0] * value(at[0]) + w[1] * value(at[1]) + w[2] * value(at[2]);
}

Vec3f baseColour(const TraceScene& scene, const Material& material, const Weights& w,
                 const std::array<std::uint32_t, 3>& at)
{
    const LocalTriangles& t = scene.triangles();
    Vec3f colour{material.baseColour.x, material.baseColour.y, material.baseColour.z};
    if (!t.colour.empty()) {
        colour.x *= float(blended(w, at, [&](std::uint32_t i) { return t.colour[i].x; }));
        colour.y *= float(blended(w, at, [&](std::uint32_t i) { return t.colour[i].y; }));
        colour.z *= float(blended(w, at, [&](std::uint32_t i) { return t.colour[i].z; }));
    }
    const Texture* texture = scene.textureOf(material);
    if (texture && !t.uv.empty()) {
        const Vec2f uv{float(blended(w, at, [&](std::uint32_t i) { return t.uv[i].x; })),
                       float(blended(w, at, [&](std::uint32_t i) { return t.uv[i].y; }))};
        const Vec3f texel = linearColourOf(*texture, uv);
        colour = {colour.x * texel.x, colour.y * texel.y, colour.z * texel.z};
    }
    return colour;
}

Vec3f shadingNormal(const LocalTriangles& t, const Weights& w, const std::array<std::uint32_t, 3>& at, Vec3f geometric)
{
    if (t.normal.empty()) return geometric;
    const Vec3d n =
        w[0] * toDouble(t.normal[at[0]]) + w[1] * toDouble(t.normal[at[1]]) + w[2] * toDouble(t.normal[at[2]]);
    if (!(length(n) > 0)) return geometric;
    return toFloat(normalized(dot(n, toDouble(geometric)) < 0 ? -n : n));
}

Colours coloursOf(const TraceScene& scene, const SurfacePoint& sample)
{
    if (sample.triangle == kNoTriangle) {
        const Material material;
        return {
            {material.baseColour.x, material.baseColour.y, material.baseColour.z}, material.emission, sample.normal};
    }
    LX_ASSERT(sample.triangle < scene.triangles().triangleCount());
    const Weights w = weightsOf(scene.corners(sample.triangle), toDouble(sample.positionLocal));
    const std::array<std::uint32_t, 3> at = scene.cornerIndices(sample.triangle);
    const Material& material = scene.materialOf(sample.triangle);
    return {baseColour(scene, material, w, at), material.emission,
            shadingNormal(scene.triangles(), w, at, sample.normal)};
}

} // namespace

SurfaceColours surfaceColours(const TraceScene& scene, const ViewSamples& samples)
{
    LX_ASSERT(samples.originWorld == scene.originWorld());
    SurfaceColours out;
    out.baseColour.resize(samples.size());
    out.emission.resize(samples.size());
    out.shadingNormal.resize(samples.size());
    forEachBlock(samples.size(), 4096, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Colours colours = coloursOf(scene, surfacePoint(samples, i));
            out.baseColour[i] = colours.base;
            out.emission[i] = colours.emission;
            out.shadingNormal[i] = colours.normal;
        }
    });
    return out;
}

} // namespace lixel
