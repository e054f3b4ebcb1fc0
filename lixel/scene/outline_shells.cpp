// SPDX-License-Identifier: MIT
#include "lixel/scene/outline_shells.h"

#include "lixel/scene/input_file.h"
#include "lixel/scene/pose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace lixel {
namespace {

constexpr double kMostLuminance = 0.05;  // linear; what an artist calls black
constexpr double kMostOpen = 0.1;        // of the directed edges
constexpr double kLeastInsideOut = -0.5; // of the volume that the triangles span

bool looksLikeInk(const Material& material)
{
    const Vec4f& c = material.baseColour; // Rec. 709 weights
    return !material.doubleSided && material.alphaMode == AlphaMode::Opaque && material.texture < 0 &&
           material.emission == Vec3f{} && 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z < kMostLuminance;
}

// The corners of all triangles, each as the number of its position: corners at one place share a number.
std::vector<std::uint32_t> weldedCorners(const Mesh& mesh)
{
    const auto key = [&](std::uint32_t v) {
        const Vec3f& p = mesh.position[v];
        return std::tuple(p.x, p.y, p.z);
    };
    std::vector<std::uint32_t> order(mesh.position.size()), number(mesh.position.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool isNew = i == 0 || key(order[i - 1]) != key(order[i]);
        number[order[i]] = isNew ? order[i] : number[order[i - 1]];
    }
    std::vector<std::uint32_t> corners;
    corners.reserve(mesh.indices.size());
    for (const std::uint32_t i : mesh.indices) corners.push_back(number[i]);
    return corners;
}

// The share of directed edges that no other edge runs along in the opposite direction.
double openShare(const std::vector<std::uint32_t>& corners)
{
    struct Edge
    {
        std::uint32_t low, high;
        int direction;
    };
    std::vector<Edge> edges;
    edges.reserve(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t a = corners[i], b = corners[i % 3 == 2 ? i - 2 : i + 1];
        if (a != b) edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
    const auto key = [](const Edge& e) { return std::pair(e.low, e.high); };
    std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return key(a) < key(b); });
    std::size_t alone = 0;
    for (std::size_t i = 0; i < edges.size();) {
        int sum = 0;
        const auto edge = key(edges[i]);
        for (; i < edges.size() && key(edges[i]) == edge; ++i) sum += edges[i].direction;
        alone += std::size_t(std::abs(sum));
    }
    return edges.empty() ? 1 : double(alone) / double(edges.size());
}

// For each corner one corner's number that all of its connected part share.
std::vector<std::uint32_t> connectedParts(const std::vector<std::uint32_t>& corners, std::size_t positions)
{
    std::vector<std::uint32_t> parent(positions);
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t v) {
        while (parent[v] != v) v = parent[v] = parent[parent[v]];
        return v;
    };
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        parent[root(corners[i])] = root(corners[i + 1]);
        parent[root(corners[i + 1])] = root(corners[i + 2]);
    }
    std::vector<std::uint32_t> parts;
    parts.reserve(corners.size());
    for (const std::uint32_t c : corners) parts.push_back(root(c));
    return parts;
}

// From -1, all inside out, to +1. Each part has its own middle, so that how parts lie to each other counts for nothing.
double orientation(const Mesh& mesh, const std::vector<std::uint32_t>& parts)
{
    std::vector<Box> boxes(mesh.position.size());
    const auto corner = [&](std::size_t i) { return toDouble(mesh.position[mesh.indices[i]]); };
    for (std::size_t i = 0; i < parts.size(); ++i) boxes[parts[i]].include(corner(i));
    double signedVolume = 0, volume = 0;
    for (std::size_t i = 0; i < parts.size(); i += 3) {
        const Vec3d middle = boxes[parts[i]].centre();
        const double tetrahedron = dot(corner(i) - middle, cross(corner(i + 1) - middle, corner(i + 2) - middle));
        signedVolume += tetrahedron, volume += std::abs(tetrahedron);
    }
    return volume > 0 ? signedVolume / volume : 0;
}

} // namespace

bool isOutlineShell(const Mesh& mesh, const Material& material)
{
    if (mesh.indices.empty() || !looksLikeInk(material)) return false;
    const std::vector<std::uint32_t> corners = weldedCorners(mesh);
    return openShare(corners) <= kMostOpen &&
           orientation(mesh, connectedParts(corners, mesh.position.size())) < kLeastInsideOut;
}

void leaveOutOutlineShells(Scene& scene, const std::string& file)
{
    std::vector<bool> isShell;
    for (const Mesh& mesh : scene.meshes)
        isShell.push_back(isOutlineShell(mesh, scene.materials[std::size_t(mesh.material)]));

    const std::vector<int> drawn = drawnNodes(scene);
    std::size_t shells = 0, others = 0;
    std::string first;
    for (const int n : drawn)
        for (const int m : scene.nodes[std::size_t(n)].meshes) {
            if (!isShell[std::size_t(m)]) ++others;
            else if (++shells == 1) first = scene.nodes[std::size_t(n)].name;
        }
    if (shells == 0 || others == 0) return;
    for (const int n : drawn)
        std::erase_if(scene.nodes[std::size_t(n)].meshes, [&](int m) { return isShell[std::size_t(m)]; });
    scene.warnings.push_back(
        fmt::format("{}: {} left out, black shells turned inside out that culling would show as outlines (first: '{}')",
                    file, shells == 1 ? "1 mesh" : fmt::format("{} meshes", shells), printable(first)));
}

} // namespace lixel
