// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/plan_tables.h"

#include "lixel/base/assert.h"
#include "lixel/gl/device/draw_state.h"
#include "lixel/shared/gl_slots.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace lixel::gl {

void PlanTables::upload(const FramePlan& plan)
{
    regions_.assign(std::span<const shared::ShadowRegion>(plan.regionTable));
    halfSpaces_.assign(std::span<const shared::vec4>(plan.halfSpaceTable));
    lights_.assign(std::span<const shared::ShadowLight>(plan.lightTable));
    warps_.assign(std::span<const float>(plan.warpTable));
    regionCount_ = plan.regionTable.size(), halfSpaceCount_ = plan.halfSpaceTable.size();
    knotCount_ = plan.warpTable.size();
}

PlanTables::Content PlanTables::download() const
{
    Content content;
    content.regions.resize(regionCount_);
    content.halfSpaces.resize(halfSpaceCount_);
    regions_.read(0, std::span<shared::ShadowRegion>(content.regions));
    halfSpaces_.read(0, std::span<shared::vec4>(content.halfSpaces));
    content.warpKnots.resize(knotCount_);
    warps_.read(0, std::span<float>(content.warpKnots));
    return content;
}

void PlanTables::bind() const
{
    regions_.bindStorage(shared::kStorageRegions);
    halfSpaces_.bindStorage(shared::kStorageHalfSpaces);
    lights_.bindStorage(shared::kStorageLights);
    warps_.bindStorage(shared::kStorageWarps);
}

void PlanTables::copyRegion(std::size_t index, Buffer& to) const
{
    LX_ASSERT(index < regionCount_);
    to.reserve(sizeof(shared::ShadowRegion));
    glCopyNamedBufferSubData(regions_.name(), to.name(), GLintptr(index * sizeof(shared::ShadowRegion)), 0,
                             sizeof(shared::ShadowRegion));
}

void ShadowAtlas::resize(const Device& device, const FramePlan& plan)
{
    // Where every light is refused one lixel is left, so that there is a texture to bind.
    const int width = std::max(plan.atlas.width, 1), height = std::max(plan.atlas.height, 1);
    const int layers = std::max(plan.layers, 1);
    if (depth.name() && depth.width() == width && depth.height() == height && depth.layers() == layers) return;
    const int side = device.limits().textureSize;
    if (width > side || height > side)
        throw GraphicsError(
            fmt::format("a shadow map of {} x {} lixels is asked for, the graphics device takes {} a side; "
                        "use --executor trace",
                        width, height, side));
    if (layers > device.limits().textureLayers)
        throw GraphicsError(fmt::format("{} shadow maps are asked for, the graphics device takes {} at once; use "
                                        "--executor trace",
                                        layers, device.limits().textureLayers));
    depth.resize(GL_DEPTH_COMPONENT32F, width, height, layers);
    framebuffer = Framebuffer({}, &depth);
}

std::vector<Image<float>> ShadowAtlas::download(int layers) const
{
    std::vector<Image<float>> maps;
    applyPixelTransfer();
    for (int layer = 0; layer < layers; ++layer) {
        Image<float>& map = maps.emplace_back(depth.width(), depth.height());
        glGetTextureSubImage(depth.name(), 0, 0, 0, layer, depth.width(), depth.height(), 1, GL_DEPTH_COMPONENT,
                             GL_FLOAT, GLsizei(map.data().size() * sizeof(float)), map.data().data());
    }
    return maps;
}

} // namespace lixel::gl
