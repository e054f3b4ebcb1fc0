// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/volume_casters.h"

#include "lixel/gl/passes/mesh_edges.h"
#include "lixel/shared/gl_slots.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace lixel::gl {
namespace {

static_assert(sizeof(MeshEdge) == 16); // as volume_edges.glsl has it

// Whether light passes through holes in a surface.
bool hasMaskedCasters(const CasterBuffers& casters)
{
    const auto isMasked = [&](std::uint32_t material) {
        return material < casters.materials.size() && casters.materials[material].alphaMode == AlphaMode::Mask;
    };
    return std::any_of(casters.meshes.begin(), casters.meshes.end(), [&](const CasterMesh& mesh) {
        if (mesh.material.empty()) return !mesh.positions.empty() && isMasked(0);
        return std::any_of(mesh.material.begin(), mesh.material.end(), isMasked);
    });
}

} // namespace

void VolumeCasters::update(const CasterBuffers& casters)
{
    if (casters.version != 0 && casters.version == version_) return;
    version_ = 0; // until all of it is here
    const LocalTriangles triangles = flatten(casters);
    const MeshEdges mesh = edgesOf(triangles.positionLocal, triangles.indices);
    const std::size_t largest =
        std::max({triangles.indices.size() * sizeof(std::uint32_t), triangles.positionLocal.size() * sizeof(Vec3f),
                  mesh.edges.size() * sizeof(MeshEdge)});
    if (largest > std::size_t(device_->limits().storageBlockBytes))
        throw GraphicsError(
            fmt::format("shadow volumes: the scene has {} triangles and {} edges, the graphics device takes {} "
                        "bytes in one buffer",
                        triangles.triangleCount(), mesh.edges.size(), device_->limits().storageBlockBytes));
    originWorld_ = triangles.originWorld;
    triangleCount_ = std::uint32_t(triangles.triangleCount());
    edgeCount_ = std::uint32_t(mesh.edges.size());
    for (Buffer* buffer : {&indices_, &positions_, &edges_, &uses_})
        buffer->reserve(sizeof(MeshEdge)); // OpenGL binds no empty one
    indices_.assign(std::span<const std::uint32_t>(triangles.indices));
    positions_.assign(std::span<const Vec3f>(triangles.positionLocal));
    edges_.assign(std::span<const MeshEdge>(mesh.edges));
    uses_.assign(std::span<const std::uint32_t>(mesh.uses));
    version_ = casters.version;
}

void VolumeCasters::bind() const
{
    indices_.bindStorage(shared::kStorageIndices);
    positions_.bindStorage(shared::kStoragePositions);
    edges_.bindStorage(shared::kStorageEdges);
    uses_.bindStorage(shared::kStorageEdgeUses);
}

std::optional<VolumeFailure> whyNoVolumes(const CasterBuffers& casters, const View& view)
{
    if (hasMaskedCasters(casters)) return VolumeFailure::MaskedCasters;
    if (view.eyeAnchored.w == 0) return VolumeFailure::ParallelView;
    return std::nullopt;
}

} // namespace lixel::gl
