// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/box.h"
#include "lixel/base/plane.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lixel::gl {

// Triangles that follow each other in drawing order and lie together, with a box around them: what is culled at once.
struct CasterRun
{
    std::uint32_t firstTriangle = 0, triangleCount = 0;
    int maskedRange = -1; // into Surfaces::ranges() where it has holes, else -1
    Box boxLocal;
};

// One draw as OpenGL reads it from a buffer (DrawElementsIndirectCommand).
struct DrawCommand
{
    std::uint32_t indexCount = 0, instanceCount = 0, firstIndex = 0;
    std::int32_t baseVertex = 0;
    std::uint32_t baseInstance = 0;
};

// One instance of a draw, as caster.vert.glsl reads it: the region it goes into, and where its draw begins.
struct CasterInstance
{
    std::uint32_t region = 0, firstTriangle = 0;
};

// Which runs of casters are drawn into which regions, as draws: a run that several regions need is drawn once, an instance a
// region, and runs beside each other that the same regions need are one draw.
class CasterDraws
{
public:
    // For regions [firstRegion, firstRegion + volumes.size()), at most 32; volumes[i] is casterVolume() of region firstRegion + i.
    // Only regions whose bit is in `among` (bit i is region firstRegion + i) are drawn.
    // A run is left out of a region only where it lies outside by more than rounding on the way to the map could make up.
    void list(std::span<const CasterRun> runs, std::span<const std::vector<Plane>> volumes, std::uint32_t firstRegion,
              std::uint32_t among = ~0u);

    // Draws that share program and texture: [first, first + count) of commands().
    struct Group
    {
        int maskedRange = -1;
        std::uint32_t first = 0, count = 0;
    };
    const std::vector<Group>& groups() const { return groups_; }
    const std::vector<DrawCommand>& commands() const { return commands_; }
    const std::vector<CasterInstance>& instances() const { return instances_; }

    // Triangles times the regions they go into, and those times the regions they were left out of.
    std::uint64_t drawn() const { return drawn_; }
    std::uint64_t culled() const { return culled_; }

private:
    void add(const CasterRun& run, std::uint32_t regions, std::uint32_t firstRegion);

    std::vector<Group> groups_;
    std::vector<DrawCommand> commands_;
    std::vector<CasterInstance> instances_;
    std::uint32_t lastRegions_ = 0; // of the last command: bit i is region firstRegion + i
    std::uint64_t drawn_ = 0, culled_ = 0;
};

} // namespace lixel::gl
