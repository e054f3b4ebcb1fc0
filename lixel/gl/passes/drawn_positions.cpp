// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/drawn_positions.h"

#include "lixel/gl/device/draw_state.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>

namespace lixel::gl {

void DrawnPositions::run(const Device& device, const FramePlan& plan, const PlanTables& tables, const Surfaces& casters)
{
    const std::uint32_t before = atlas_.depth.name();
    atlas_.resize(device, plan);
    if (atlas_.depth.name() != before || !positions_.name()) {
        positions_ = Texture(GL_RGBA32F, atlas_.depth.width(), atlas_.depth.height(), atlas_.depth.layers());
        const std::array<const Texture*, 1> colours{&positions_};
        atlas_.framebuffer = Framebuffer(colours, &atlas_.depth);
    }
    const std::array<GLfloat, 4> nothing{};
    glClearTexImage(positions_.name(), 0, GL_RGBA, GL_FLOAT, nothing.data());
    pass_.run(plan, tables, casters, atlas_);
}

std::vector<Image<Vec4f>> DrawnPositions::download(int layers) const
{
    std::vector<Image<Vec4f>> maps;
    applyPixelTransfer();
    for (int layer = 0; layer < layers; ++layer) {
        Image<Vec4f>& map = maps.emplace_back(positions_.width(), positions_.height());
        glGetTextureSubImage(positions_.name(), 0, 0, 0, layer, positions_.width(), positions_.height(), 1, GL_RGBA,
                             GL_FLOAT, GLsizei(map.data().size() * sizeof(Vec4f)), map.data().data());
    }
    return maps;
}

} // namespace lixel::gl
