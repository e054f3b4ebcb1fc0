// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/sample_pass.h"

#include "lixel/base/assert.h"
#include "lixel/plan/shading_light.h"
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/observe.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lixel::gl {
namespace {

// Locations in sample.comp.glsl; the first in neighbours.comp.glsl too.
constexpr int kGrid = 0, kPicture = 1, kFirstPoint = 2, kPointCount = 3, kLightCount = 4;

static_assert(sizeof(shared::ObservedPoint) == 48 && offsetof(shared::ObservedPoint, lit) == 32);

} // namespace

SamplePass::SamplePass(const Device& device)
    : device_(&device),
      sample_(Program::compute("sample.comp.glsl")),
      neighbours_(Program::compute("neighbours.comp.glsl"))
{
}

void SamplePass::run(const PointList& points, const VisibilityList& visibility, std::span<const Light> lights,
                     ObservationGrid grid)
{
    LX_ASSERT(points.size() == std::size_t(points.width()) * std::size_t(points.height()));
    LX_ASSERT(visibility.lights() == 0 || visibility.lights() == lights.size());
    const std::size_t count = std::size_t(grid.width) * std::size_t(grid.height);
    if (count > entriesPerPart(*device_, sizeof(shared::ObservedPoint)))
        throw GraphicsError(fmt::format("an observation of {} x {} samples is asked for, the graphics device takes {}",
                                        grid.width, grid.height,
                                        entriesPerPart(*device_, sizeof(shared::ObservedPoint))));
    std::vector<shared::ShadingLight> table;
    for (const Light& light : lights.first(std::min(visibility.lights(), kObservedLights)))
        table.push_back(shadingLight(light, points.originWorld()));
    lights_.assign(std::span<const shared::ShadingLight>(table));
    lights_.bindStorage(shared::kStorageShadingLights);
    bytes_ = count * sizeof(shared::ObservedPoint);
    cells_.reserve(bytes_);
    cells_.bindStorage(shared::kStorageCells, 0, bytes_);

    const auto groups = GLuint((count + 63) / 64);
    sample_.set(kGrid, grid.width, grid.height);
    sample_.set(kPicture, points.width(), points.height());
    sample_.set(kLightCount, int(table.size()));
    sample_.use();
    for (const PointList::Part& part : visibility.parts()) {
        points.bind(part);
        visibility.bind(part);
        sample_.set(kFirstPoint, std::uint32_t(part.first));
        sample_.set(kPointCount, std::uint32_t(part.count));
        glDispatchCompute(groups, 1, 1);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    neighbours_.set(kGrid, grid.width, grid.height);
    neighbours_.use();
    glDispatchCompute(groups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

} // namespace lixel::gl
