// SPDX-License-Identifier: MIT
#include "lixel/trace/trace_scene.h"

#include "lixel/base/assert.h"
#include "lixel/trace/texture_lookup.h"

#include "lixel/shared/alpha.h"

#include <algorithm>
#include <utility>

namespace lixel {
namespace {

Box boxOfCorners(const LocalTriangles& triangles)
{
    Box box;
    for (const std::uint32_t corner : triangles.indices) box.include(toDouble(triangles.positionLocal[corner]));
    return box;
}

Box widened(const Box& box, double by)
{
    if (box.isEmpty()) return box;
    return {box.min - Vec3d{by, by, by}, box.max + Vec3d{by, by, by}};
}

} // namespace

TraceScene::TraceScene(LocalTriangles triangles, std::span<const Material> materials, std::span<const Texture> textures)
    : triangles_(std::move(triangles)),
      materials_(materials.begin(), materials.end()),
      textures_(textures),
      boxLocal_(boxOfCorners(triangles_)),
      embree_(triangles_.positionLocal, triangles_.indices)
{
    const std::size_t positions = triangles_.positionLocal.size();
    LX_ASSERT(triangles_.indices.size() % 3 == 0);
    LX_ASSERT(triangles_.material.size() == triangles_.triangleCount());
    LX_ASSERT(triangles_.uv.empty() || triangles_.uv.size() == positions);
    LX_ASSERT(triangles_.colour.empty() || triangles_.colour.size() == positions);
    LX_ASSERT(triangles_.normal.empty() || triangles_.normal.size() == positions);
    if (materials_.empty()) materials_.emplace_back();
    for (const std::uint32_t material : triangles_.material) LX_ASSERT(material < materials_.size());
    for (const Material& material : materials_) {
        LX_ASSERT(material.texture < int(textures_.size()));
        anyMasked_ |= material.alphaMode == AlphaMode::Mask;
    }
    searchBoxLocal_ = widened(boxLocal_, 2 * embree_.margin());
}

TraceScene::TraceScene(const CasterBuffers& casters) : TraceScene(flatten(casters), casters.materials, casters.textures)
{
}

const Material& TraceScene::materialOf(std::uint32_t triangle) const
{
    return materials_[triangles_.material[triangle]];
}

const Texture* TraceScene::textureOf(const Material& material) const
{
    if (material.texture < 0) return nullptr;
    const Texture& texture = textures_[std::size_t(material.texture)];
    return texture.pixels.data().empty() ? nullptr : &texture;
}

bool TraceScene::isMasked(std::uint32_t triangle) const
{
    return anyMasked_ && materialOf(triangle).alphaMode == AlphaMode::Mask;
}

std::array<std::uint32_t, 3> TraceScene::cornerIndices(std::uint32_t triangle) const
{
    const std::uint32_t* corner = triangles_.indices.data() + 3 * std::size_t(triangle);
    return {corner[0], corner[1], corner[2]};
}

Corners TraceScene::corners(std::uint32_t triangle) const
{
    const std::array<std::uint32_t, 3> at = cornerIndices(triangle);
    return {toDouble(triangles_.positionLocal[at[0]]), toDouble(triangles_.positionLocal[at[1]]),
            toDouble(triangles_.positionLocal[at[2]])};
}

bool TraceScene::keeps(std::uint32_t triangle, float u, float v) const
{
    if (!isMasked(triangle)) return true;
    const Material& material = materialOf(triangle);
    const std::array<std::uint32_t, 3> at = cornerIndices(triangle);
    float vertexAlpha = 1, textureAlpha = 1;
    if (!triangles_.colour.empty()) {
        const std::vector<Vec4f>& colour = triangles_.colour;
        vertexAlpha = (1 - u - v) * colour[at[0]].w + u * colour[at[1]].w + v * colour[at[2]].w;
    }
    const Texture* texture = textureOf(material);
    if (texture && !triangles_.uv.empty()) {
        const Vec2f a = triangles_.uv[at[0]], b = triangles_.uv[at[1]], c = triangles_.uv[at[2]];
        textureAlpha =
            alphaOf(*texture, {(1 - u - v) * a.x + u * b.x + v * c.x, (1 - u - v) * a.y + u * b.y + v * c.y});
    }
    return shared::isKept(material.baseColour.w, vertexAlpha, textureAlpha, material.alphaCutoff);
}

} // namespace lixel
