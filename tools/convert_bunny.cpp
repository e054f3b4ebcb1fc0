// SPDX-License-Identifier: MIT
// Turns the Stanford bunny of Debian's glmark2-data into the C++ tables that the built-in scenes compile in: welded,
// simplified, one unit high, its feet at y = 0 and its bounding box centred over the origin.
//
//   convert_bunny bunny.obj TRIANGLES bunny_mesh.inc
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Position
{
    float x, y, z;
};

struct TriangleMesh
{
    std::vector<Position> positions;
    std::vector<unsigned> indices;
};

// Positions and triangles are all that is read; normals are made again when the scene is built.
TriangleMesh readObj(const std::string& path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": cannot be read");
    TriangleMesh mesh;
    for (std::string line; std::getline(file, line);) {
        Position p{};
        std::array<unsigned, 3> corner{};
        if (std::sscanf(line.c_str(), "v %f %f %f", &p.x, &p.y, &p.z) == 3) mesh.positions.push_back(p);
        if (std::sscanf(line.c_str(), "f %u %u %u", &corner[0], &corner[1], &corner[2]) == 3)
            for (unsigned index : corner) mesh.indices.push_back(index - 1);
    }
    for (unsigned index : mesh.indices)
        if (index >= mesh.positions.size())
            throw std::runtime_error(path + ": a face names a vertex that is not there");
    if (mesh.indices.empty()) throw std::runtime_error(path + ": holds no triangles");
    return mesh;
}

void weld(TriangleMesh& mesh)
{
    std::vector<unsigned> remap(mesh.positions.size());
    const std::size_t unique =
        meshopt_generateVertexRemap(remap.data(), mesh.indices.data(), mesh.indices.size(), mesh.positions.data(),
                                    mesh.positions.size(), sizeof(Position));
    std::vector<Position> welded(unique);
    meshopt_remapVertexBuffer(welded.data(), mesh.positions.data(), mesh.positions.size(), sizeof(Position),
                              remap.data());
    meshopt_remapIndexBuffer(mesh.indices.data(), mesh.indices.data(), mesh.indices.size(), remap.data());
    mesh.positions = std::move(welded);
}

// Edge collapses only, so that a closed surface stays closed.
void simplify(TriangleMesh& mesh, std::size_t triangles)
{
    std::vector<unsigned> fewer(mesh.indices.size());
    fewer.resize(meshopt_simplify(fewer.data(), mesh.indices.data(), mesh.indices.size(), &mesh.positions[0].x,
                                  mesh.positions.size(), sizeof(Position), 3 * triangles, 0.1f));
    meshopt_optimizeVertexCache(fewer.data(), fewer.data(), fewer.size(), mesh.positions.size());
    std::vector<Position> used(mesh.positions.size());
    used.resize(meshopt_optimizeVertexFetch(used.data(), fewer.data(), fewer.size(), mesh.positions.data(),
                                            mesh.positions.size(), sizeof(Position)));
    mesh = {std::move(used), std::move(fewer)};
}

void standAtOrigin(TriangleMesh& mesh)
{
    Position low = mesh.positions[0], high = low;
    for (const Position& p : mesh.positions) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const float scale = 1 / (high.y - low.y);
    for (Position& p : mesh.positions)
        p = {(p.x - 0.5f * (low.x + high.x)) * scale, (p.y - low.y) * scale, (p.z - 0.5f * (low.z + high.z)) * scale};
}

// Each edge is used once in each direction.
bool isClosed(const TriangleMesh& mesh)
{
    std::map<std::pair<unsigned, unsigned>, int> uses;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        ++uses[{mesh.indices[i], mesh.indices[i % 3 == 2 ? i - 2 : i + 1]}];
    return std::all_of(uses.begin(), uses.end(), [&](const auto& use) {
        const auto opposite = uses.find({use.first.second, use.first.first});
        return use.second == 1 && opposite != uses.end();
    });
}

void write(const TriangleMesh& mesh, const std::string& path)
{
    std::ofstream file(path);
    file << "// Made by convert_bunny.\n"
         << "constexpr float kBunnyPositions[][3] = {\n";
    char line[96];
    for (const Position& p : mesh.positions) {
        std::snprintf(line, sizeof line, "{%af, %af, %af},\n", double(p.x), double(p.y), double(p.z)); // exact
        file << line;
    }
    file << "};\nconstexpr std::uint32_t kBunnyIndices[] = {\n";
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        file << mesh.indices[i] << ',' << mesh.indices[i + 1] << ',' << mesh.indices[i + 2] << ",\n";
    file << "};\n";
    file.close();
    if (!file) throw std::runtime_error(path + ": cannot be written");
}

} // namespace

int main(int argc, char** argv)
try {
    if (argc != 4) throw std::runtime_error("usage: convert_bunny bunny.obj TRIANGLES bunny_mesh.inc");
    TriangleMesh mesh = readObj(argv[1]);
    weld(mesh);
    simplify(mesh, std::size_t(std::strtoul(argv[2], nullptr, 10)));
    standAtOrigin(mesh);
    if (!isClosed(mesh)) throw std::runtime_error(std::string(argv[1]) + ": the simplified bunny is not closed");
    write(mesh, argv[3]);
} catch (const std::exception& error) {
    std::fprintf(stderr, "convert_bunny: %s\n", error.what());
    return 1;
}
