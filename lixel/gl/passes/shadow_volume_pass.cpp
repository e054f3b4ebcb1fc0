// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/shadow_volume_pass.h"

#include "lixel/base/assert.h"
#include "lixel/gl/device/draw_state.h"
#include "lixel/plan/shadow_plan.h"
#include "lixel/shared/gl_slots.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace lixel::gl {
namespace {

// Locations in volume_casters.glsl, volume_clip.glsl, volume_facing.comp.glsl and volume_sides.*.glsl.
constexpr int kLightLocal = 0, kClipFromLocal = 2, kTriangleCount = 1, kEdgeCount = 0, kSidesVertices = 1;
// In volume_samples.frag.glsl and volume_visibility.comp.glsl.
constexpr int kFirstPoint = 0, kPointCount = 1, kWidth = 2, kLight = 2;

// What glDrawArraysIndirect reads.
struct DrawCommand
{
    std::uint32_t vertexCount = 0, instanceCount = 1, firstVertex = 0, baseInstance = 0;
};

// Less than the w of anything that the view does not cut off.
double nearestW(const Mat4d& clipFromLocal)
{
    const auto localFromClip = inverse(clipFromLocal);
    LX_ASSERT(localFromClip.has_value());
    double least = std::numeric_limits<double>::max();
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) least = std::min(least, 1 / (*localFromClip * Vec4d{x, y, -1, 1}).w);
    LX_ASSERT(least > 0);
    return 0.5 * least;
}

GLuint groupsFor(std::uint32_t count) { return (count + 63) / 64; }

// For shaders that ask indexInRows(): a row has at most as many groups as every device takes.
void dispatchInRows(std::uint32_t count)
{
    constexpr GLuint kMostGroups = 65535;
    const GLuint groups = groupsFor(count), rows = (groups + kMostGroups - 1) / kMostGroups;
    if (groups > 0) glDispatchCompute((groups + rows - 1) / rows, rows, 1);
}

} // namespace

ShadowVolumePass::ShadowVolumePass()
    : facing_(Program::compute("volume_facing.comp.glsl")),
      silhouettes_(Program::compute("volume_sides.comp.glsl")),
      samples_(Program::graphics({"volume_samples.vert.glsl", "volume_samples.frag.glsl"})),
      sides_(Program::graphics({"volume_sides.vert.glsl", "volume_boundary.frag.glsl"})),
      caps_(Program::graphics({"volume_caps.vert.glsl", "volume_boundary.frag.glsl"})),
      visibility_(Program::compute("volume_visibility.comp.glsl")),
      noVertices_(makeVertexArray())
{
    const std::array<std::string, 1> far{"FAR"};
    farCaps_ = Program::graphics({"volume_caps.vert.glsl", "opaque.frag.glsl"}, far);
}

void ShadowVolumePass::begin(const VolumeCasters& casters, const View& view, const PointList& points)
{
    LX_ASSERT(view.eyeAnchored.w != 0 && casters.originWorld() == points.originWorld());
    LX_ASSERT(points.size() == std::size_t(view.width) * std::size_t(view.height));
    facingOfTriangles_.reserve(sizeof(std::uint32_t) * casters.triangleCount());
    sidesOfVolumes_.reserve(3 * sizeof(std::uint32_t) * casters.triangleCount());
    draw_.reserve(sizeof(DrawCommand));
    if (!counting_.name() || sampleOfPixel_.width() != view.width || sampleOfPixel_.height() != view.height) {
        sampleOfPixel_.resize(GL_RGBA32UI, view.width, view.height);
        volumes_.resize(GL_STENCIL_INDEX8, view.width, view.height);
        const std::array<const Texture*, 1> colour{&sampleOfPixel_};
        withSamples_ = Framebuffer(colour, nullptr);
        counting_ = Framebuffer({}, &volumes_);
    }
    Mat4d clip = clipFromLocal(view, casters.originWorld());
    const double nearest = nearestW(clip);
    drawSamples(points);

    for (int column = 0; column < 4; ++column) clip.m[2][column] = column == 3 ? nearest : 0;
    const shared::mat4 clipInFloats = toShared(clip);
    for (const Program* program : {&sides_, &caps_, &farCaps_})
        glProgramUniformMatrix4fv(program->name(), kClipFromLocal, 1, GL_FALSE, &clipInFloats.columns[0].x);
}

void ShadowVolumePass::drawSamples(const PointList& points)
{
    apply(DrawState{});
    withSamples_.bind();
    const std::array<GLuint, 4> none{0, 0, 0, 0xffffffffu};
    glClearNamedFramebufferuiv(withSamples_.name(), GL_COLOR, 0, none.data());
    glViewport(0, 0, volumes_.width(), volumes_.height());
    glBindVertexArray(noVertices_.get());

    samples_.set(kWidth, std::uint32_t(volumes_.width()));
    samples_.use();
    for (const PointList::Part& part : points.parts()) {
        points.bind(part);
        samples_.set(kFirstPoint, std::uint32_t(part.first));
        samples_.set(kPointCount, std::uint32_t(part.count));
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

void ShadowVolumePass::findSilhouettes(const VolumeCasters& casters, const Light& light)
{
    isPointLight_ = light.kind != LightKind::Directional;
    verticesASide_ = isPointLight_ ? 6 : 3;
    const DrawCommand nothing;
    draw_.write(0, std::span<const DrawCommand>(&nothing, 1));
    if (casters.triangleCount() == 0) return;
    const Vec3d to = isPointLight_ ? light.positionWorld - casters.originWorld() : -light.directionWorld;
    for (const Program* program : {&facing_, &sides_, &caps_, &farCaps_})
        glProgramUniform4f(program->name(), kLightLocal, float(to.x), float(to.y), float(to.z),
                           isPointLight_ ? 1.0f : 0.0f);

    casters.bind();
    facingOfTriangles_.bindStorage(shared::kStorageFacing);
    sidesOfVolumes_.bindStorage(shared::kStorageSides);
    draw_.bindStorage(shared::kStorageSideDraw);
    facing_.set(kTriangleCount, casters.triangleCount());
    facing_.use();
    dispatchInRows(casters.triangleCount());
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    silhouettes_.set(kEdgeCount, casters.edgeCount());
    silhouettes_.set(kSidesVertices, verticesASide_);
    silhouettes_.use();
    dispatchInRows(casters.edgeCount());
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void ShadowVolumePass::count(const VolumeCasters& casters)
{
    DrawState state;
    state.counts = true;
    apply(state);
    counting_.bind();
    const GLint zero = 0;
    glClearNamedFramebufferiv(counting_.name(), GL_STENCIL, 0, &zero);
    if (casters.triangleCount() == 0) return;
    glViewport(0, 0, volumes_.width(), volumes_.height());
    glBindVertexArray(noVertices_.get());
    casters.bind();
    facingOfTriangles_.bindStorage(shared::kStorageFacing);
    sidesOfVolumes_.bindStorage(shared::kStorageSides);
    sampleOfPixel_.bind(shared::kUnitSamples);

    sides_.set(kSidesVertices, verticesASide_);
    sides_.use();
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, draw_.name());
    glDrawArraysIndirect(GL_TRIANGLES, nullptr);
    const auto drawCaps = [&](const Program& program) {
        program.use();
        glDrawArrays(GL_TRIANGLES, 0, GLsizei(3 * casters.triangleCount()));
    };
    drawCaps(caps_);
    if (isPointLight_) drawCaps(farCaps_); // parallel rays end in one point
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void ShadowVolumePass::decide(const PointList& points, const VisibilityList& visibility, std::size_t light) const
{
    volumes_.bind(shared::kUnitVolumes);
    visibility_.set(kLight, int(light));
    visibility_.use();
    for (const PointList::Part& part : visibility.parts()) {
        points.bind(part);
        visibility.bind(part);
        visibility_.set(kFirstPoint, std::uint32_t(part.first));
        visibility_.set(kPointCount, std::uint32_t(part.count));
        glDispatchCompute(groupsFor(std::uint32_t(part.count)), 1, 1);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

} // namespace lixel::gl
