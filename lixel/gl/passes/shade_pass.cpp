// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/shade_pass.h"

#include "lixel/base/assert.h"
#include "lixel/gl/device/draw_state.h"
#include "lixel/plan/shading_light.h"
#include "lixel/shared/gl_slots.h"

#include <epoxy/gl.h>

#include <vector>

namespace lixel::gl {
namespace {

// Locations in shade.comp.glsl.
constexpr int kFirstPoint = 0, kPointCount = 1, kLightCount = 2;

} // namespace

ShadePass::ShadePass() : program_(Program::compute("shade.comp.glsl")) {}

void ShadePass::run(const Surfaces& surfaces, const ViewTargets& targets, const PointList& points,
                    const VisibilityList& visibility, std::span<const Light> lights)
{
    LX_ASSERT(points.size() == std::size_t(points.width()) * std::size_t(points.height()));
    LX_ASSERT(visibility.lights() == lights.size() && targets.triangles.width() == points.width());
    std::vector<shared::ShadingLight> table;
    for (const Light& light : lights) table.push_back(shadingLight(light, points.originWorld()));
    lights_.assign(std::span<const shared::ShadingLight>(table));
    lights_.bindStorage(shared::kStorageShadingLights);

    picture_.resize(GL_RGBA8, points.width(), points.height());
    glBindImageTexture(shared::kImagePicture, picture_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    targets.triangles.bind(shared::kUnitTriangles);
    targets.baseColour.bind(shared::kUnitBaseColour);
    targets.normal.bind(shared::kUnitNormal);
    surfaces.bindMaterials();
    program_.set(kLightCount, int(lights.size()));
    program_.use();
    for (const PointList::Part& part : visibility.parts()) {
        points.bind(part);
        visibility.bind(part);
        program_.set(kFirstPoint, std::uint32_t(part.first));
        program_.set(kPointCount, std::uint32_t(part.count));
        glDispatchCompute(GLuint((part.count + 63) / 64), 1, 1);
    }
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

Image<Rgba8> ShadePass::download() const
{
    Image<Rgba8> image(picture_.width(), picture_.height());
    const auto bytes = GLsizei(image.data().size() * sizeof(Rgba8));
    applyPixelTransfer();
    glGetTextureImage(picture_.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes, image.data().data());
    return image;
}

} // namespace lixel::gl
