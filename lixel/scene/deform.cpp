// SPDX-License-Identifier: MIT
#include "lixel/scene/deform.h"

#include "lixel/base/assert.h"

#include <algorithm>

namespace lixel {
namespace {

// What normals are multiplied with: the cofactors of the upper 3x3, which also serve where it mirrors or is singular.
// The sign keeps normals on the side their surface faces.
struct NormalMatrix
{
    explicit NormalMatrix(const Mat4d& a)
    {
        const Vec3d x{a.m[0][0], a.m[1][0], a.m[2][0]}, y{a.m[0][1], a.m[1][1], a.m[2][1]},
            z{a.m[0][2], a.m[1][2], a.m[2][2]};
        const double sign = dot(x, cross(y, z)) < 0 ? -1 : 1;
        columnX = sign * cross(y, z), columnY = sign * cross(z, x), columnZ = sign * cross(x, y);
    }
    Vec3f operator*(Vec3d n) const
    {
        const Vec3d turned = normalized(n.x * columnX + n.y * columnY + n.z * columnZ);
        return isFinite(turned) ? toFloat(turned) : Vec3f{};
    }
    Vec3d columnX, columnY, columnZ;
};

std::vector<Vec3d> inDouble(const std::vector<Vec3f>& values)
{
    std::vector<Vec3d> doubles(values.size());
    std::transform(values.begin(), values.end(), doubles.begin(), [](Vec3f v) { return toDouble(v); });
    return doubles;
}

void addTarget(std::vector<Vec3d>& values, const std::vector<Vec3f>& displacement, double weight)
{
    if (weight == 0) return;
    for (std::size_t i = 0; i < std::min(values.size(), displacement.size()); ++i)
        values[i] = values[i] + weight * toDouble(displacement[i]);
}

// The node's weights, else the mesh's own; targets without a weight rest.
std::vector<double> weightsOf(const Mesh& mesh, const std::vector<double>& nodeWeights)
{
    std::vector<double> weights = nodeWeights;
    if (weights.empty()) weights.assign(mesh.defaultMorphWeights.begin(), mesh.defaultMorphWeights.end());
    weights.resize(mesh.morphTargets.size(), 0);
    return weights;
}

std::vector<Mat4d> jointMatrices(const Skin& skin, const Pose& pose, const Mat4d& localFromWorld)
{
    std::vector<Mat4d> localFromBind;
    for (std::size_t j = 0; j < skin.joints.size(); ++j)
        localFromBind.push_back(localFromWorld * pose.worldFromNode[std::size_t(skin.joints[j])] *
                                skin.modelFromBindInverse[j]);
    return localFromBind;
}

// The joints' matrices, each by its share of the vertex's weight; `other` where it has none.
Mat4d blend(const std::vector<Mat4d>& joints, const Mesh& mesh, std::size_t vertex, const Mat4d& other)
{
    const std::size_t n = std::size_t(mesh.influences), first = vertex * n;
    double total = 0;
    for (std::size_t i = first; i < first + n; ++i) total += double(mesh.weights[i]);
    if (!(total > 0)) return other;
    Mat4d sum;
    for (int row = 0; row < 3; ++row) sum.setRow(row, {});
    for (std::size_t i = first; i < first + n; ++i) {
        if (mesh.weights[i] == 0) continue;
        const Mat4d& joint = joints[mesh.joints[i]];
        for (int row = 0; row < 3; ++row)
            sum.setRow(row, sum.row(row) + double(mesh.weights[i]) / total * joint.row(row));
    }
    return sum;
}

} // namespace

PlacedMesh placeMesh(const Scene& scene, const Pose& pose, int node, const Mesh& mesh, Vec3d originWorld)
{
    std::vector<Vec3d> positions = inDouble(mesh.position), normals = inDouble(mesh.normal);
    const std::vector<double> weights = weightsOf(mesh, pose.morphWeights[std::size_t(node)]);
    for (std::size_t t = 0; t < weights.size(); ++t) {
        addTarget(positions, mesh.morphTargets[t].position, weights[t]);
        addTarget(normals, mesh.morphTargets[t].normal, weights[t]);
    }

    PlacedMesh placed;
    placed.normal.resize(normals.size());
    const Mat4d localFromWorld = translation(-originWorld);
    const Mat4d localFromNode = localFromWorld * pose.worldFromNode[std::size_t(node)];
    const int skin = scene.nodes[std::size_t(node)].skin;
    if (skin < 0 || mesh.influences == 0) {
        const NormalMatrix normalMatrix(localFromNode);
        for (Vec3d& p : positions) p = transformPoint(localFromNode, p);
        for (std::size_t i = 0; i < normals.size(); ++i) placed.normal[i] = normalMatrix * normals[i];
    } else {
        LX_ASSERT(mesh.weights.size() == positions.size() * std::size_t(mesh.influences));
        const std::vector<Mat4d> joints = jointMatrices(scene.skins[std::size_t(skin)], pose, localFromWorld);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Mat4d localFromModel = blend(joints, mesh, i, localFromNode);
            positions[i] = transformPoint(localFromModel, positions[i]);
            if (!normals.empty()) placed.normal[i] = NormalMatrix(localFromModel) * normals[i];
        }
    }
    placed.positionLocal = std::move(positions);
    return placed;
}

} // namespace lixel
