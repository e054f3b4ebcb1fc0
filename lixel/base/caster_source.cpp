// SPDX-License-Identifier: MIT
#include "lixel/base/caster_source.h"

namespace lixel {
namespace {

// Appends `count` values of a mesh, or defaults where the mesh has none, if any mesh of the source has some.
template <typename T>
void append(std::vector<T>& all, std::span<const T> some, bool wanted, std::size_t count, T missing)
{
    if (!wanted) return;
    if (some.empty()) all.insert(all.end(), count, missing);
    else all.insert(all.end(), some.begin(), some.end());
}

Vec3f transformedNormal(const Mat4d& cofactor, Vec3f normal)
{
    return toFloat(normalized(transformDirection(cofactor, toDouble(normal))));
}

// Of the upper 3x3: what normals are multiplied with, also where the matrix mirrors or is singular.
Mat4d cofactor(const Mat4d& a)
{
    const Vec3d c0{a.m[0][0], a.m[1][0], a.m[2][0]}, c1{a.m[0][1], a.m[1][1], a.m[2][1]},
        c2{a.m[0][2], a.m[1][2], a.m[2][2]};
    const Vec3d n0 = cross(c1, c2), n1 = cross(c2, c0), n2 = cross(c0, c1);
    const double sign = dot(c0, n0) < 0 ? -1 : 1;
    return Mat4d::fromRows({sign * n0.x, sign * n1.x, sign * n2.x, 0}, {sign * n0.y, sign * n1.y, sign * n2.y, 0},
                           {sign * n0.z, sign * n1.z, sign * n2.z, 0}, {0, 0, 0, 1});
}

} // namespace

LocalTriangles flatten(const CasterBuffers& casters)
{
    bool anyUv = false, anyColour = false, anyNormals = false;
    std::size_t positions = 0, indices = 0;
    for (const CasterMesh& mesh : casters.meshes) {
        anyUv |= !mesh.uv.empty(), anyColour |= !mesh.colour.empty(), anyNormals |= !mesh.normals.empty();
        const std::size_t instances = mesh.localFromModel.empty() ? 1 : mesh.localFromModel.size();
        positions += instances * mesh.positions.size();
        indices += instances * (mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size());
    }
    LocalTriangles out;
    out.originWorld = casters.originWorld;
    out.positionLocal.reserve(positions);
    out.indices.reserve(indices);
    out.material.reserve(indices / 3);
    const Mat4d identity;
    for (const CasterMesh& mesh : casters.meshes) {
        const std::span<const Mat4d> instances =
            mesh.localFromModel.empty() ? std::span<const Mat4d>(&identity, 1) : mesh.localFromModel;
        const std::size_t corners = mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size();
        for (const Mat4d& localFromModel : instances) {
            const auto first = std::uint32_t(out.positionLocal.size());
            const bool isPlaced = localFromModel == identity;
            for (const Vec3f& p : mesh.positions)
                out.positionLocal.push_back(isPlaced ? p : toFloat(transformPoint(localFromModel, toDouble(p))));
            for (std::size_t c = 0; c < corners / 3 * 3; ++c)
                out.indices.push_back(first + (mesh.indices.empty() ? std::uint32_t(c) : mesh.indices[c]));
            append(out.material, mesh.material, true, corners / 3, 0u);
            append(out.uv, mesh.uv, anyUv, mesh.positions.size(), Vec2f{});
            append(out.colour, mesh.colour, anyColour, mesh.positions.size(), Vec4f{1, 1, 1, 1});
            const std::size_t firstNormal = out.normal.size();
            append(out.normal, mesh.normals, anyNormals, mesh.positions.size(), Vec3f{});
            if (!isPlaced && !mesh.normals.empty()) {
                const Mat4d normalMatrix = cofactor(localFromModel);
                for (std::size_t i = firstNormal; i < out.normal.size(); ++i)
                    out.normal[i] = transformedNormal(normalMatrix, out.normal[i]);
            }
        }
    }
    return out;
}

} // namespace lixel
