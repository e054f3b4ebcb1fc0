// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/sdsm_pass.h"

#include "lixel/plan/partition/partition.h"
#include "lixel/shared/gl_slots.h"

#include <epoxy/gl.h>

#include <array>
#include <span>
#include <string>

namespace lixel::gl {
namespace {

constexpr int kPointCount = 0; // location in sdsm_samples.comp.glsl
constexpr std::size_t kPointsOfGroup = 64 * 64;
constexpr std::size_t kWords = 2 + 7 * kMostCells; // of sdsm.glsl

} // namespace

SdsmPass::SdsmPass()
    : depths_(Program::compute("sdsm_samples.comp.glsl")), regions_(Program::compute("sdsm_regions.comp.glsl"))
{
    const std::array<std::string, 1> bounds{"BOUNDS"};
    bounds_ = Program::compute("sdsm_samples.comp.glsl", bounds);
}

void SdsmPass::run(const SdsmFill& fill, const PointList& points, const PlanTables& tables)
{
    setup_.assign(std::span<const shared::SdsmSetup>(&fill.setup, 1));
    setup_.bindUniform(shared::kUniformSdsm, sizeof(shared::SdsmSetup));
    casters_.assign(std::span<const shared::SdsmCasters>(fill.casters));
    casters_.bindStorage(shared::kStorageSdsmCasters);
    greatest_.reserve(kWords * sizeof(std::uint32_t));
    greatest_.clear(0, kWords * sizeof(std::uint32_t));
    greatest_.bindStorage(shared::kStorageSdsm);
    tables.bind();

    for (const Program* reduction : {&depths_, &bounds_}) {
        reduction->use();
        for (const PointList::Part& part : points.parts()) {
            points.bind(part);
            reduction->set(kPointCount, std::uint32_t(part.count));
            glDispatchCompute(GLuint((part.count + kPointsOfGroup - 1) / kPointsOfGroup), 1, 1);
        }
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    regions_.use();
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

} // namespace lixel::gl
