// SPDX-License-Identifier: MIT
#include "mesh.h"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

using namespace lixel;

namespace {

struct Corner
{
    Vec3d positionWorld, colour;
};

struct Object
{
    std::string name;
    std::vector<Corner> corners; // three a triangle
};

std::uint16_t pack565(Vec3d c)
{
    const auto bits = [](double v, int most) { return unsigned(std::lround(std::clamp(v, 0.0, 1.0) * most)); };
    return std::uint16_t(bits(c.x, 31) << 11 | bits(c.y, 63) << 5 | bits(c.z, 31));
}

// The unit sphere folded into a square: an octahedron, its lower half turned outwards.
void packNormal(Vec3d n, std::int16_t (&out)[2])
{
    const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    double u = n.x / sum, v = n.y / sum;
    if (n.z < 0) {
        const double folded = (1 - std::abs(v)) * (u < 0 ? -1 : 1);
        v = (1 - std::abs(u)) * (v < 0 ? -1 : 1);
        u = folded;
    }
    out[0] = std::int16_t(std::lround(u * 32767));
    out[1] = std::int16_t(std::lround(v * 32767));
}

HostMesh quantized(const Object& object)
{
    HostMesh mesh{object.name, {}, {}};
    for (const Corner& corner : object.corners) mesh.boxWorld.include(corner.positionWorld);
    const Vec3d low = mesh.boxWorld.min, size = mesh.boxWorld.max - low;
    const auto fraction = [](double offset, double whole) {
        return std::uint16_t(std::lround(whole > 0 ? 65535 * offset / whole : 0));
    };
    for (std::size_t i = 0; i + 2 < object.corners.size(); i += 3) {
        const Corner* c = &object.corners[i];
        const Vec3d across = cross(c[1].positionWorld - c[0].positionWorld, c[2].positionWorld - c[0].positionWorld);
        if (!(length(across) > 0)) continue;
        for (int k = 0; k < 3; ++k) {
            const Vec3d p = c[k].positionWorld - low;
            HostVertex v{
                {fraction(p.x, size.x), fraction(p.y, size.y), fraction(p.z, size.z)}, pack565(c[k].colour), {}};
            packNormal(normalized(across), v.normal);
            mesh.vertices.push_back(v);
        }
    }
    return mesh;
}

} // namespace

std::vector<HostMesh> loadObj(const std::string& path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": cannot be read");
    std::vector<Corner> points;
    std::vector<Object> objects(1);
    std::string text;
    for (int line = 1; std::getline(file, text); ++line) {
        std::istringstream words(text);
        std::string kind;
        words >> kind;
        if (kind == "o") {
            objects.emplace_back();
            std::getline(words >> std::ws, objects.back().name);
        } else if (kind == "v") {
            Corner c;
            words >> c.positionWorld.x >> c.positionWorld.y >> c.positionWorld.z >> c.colour.x >> c.colour.y >>
                c.colour.z;
            if (!words) throw std::runtime_error(path + ":" + std::to_string(line) + ": six numbers are expected");
            points.push_back(c);
        } else if (kind == "f") {
            std::vector<Corner> face;
            for (std::size_t index = 0; words >> index;) {
                if (index == 0 || index > points.size())
                    throw std::runtime_error(path + ":" + std::to_string(line) + ": no such vertex");
                face.push_back(points[index - 1]);
            }
            for (std::size_t k = 2; k < face.size(); ++k)
                for (const std::size_t corner : {std::size_t(0), k - 1, k})
                    objects.back().corners.push_back(face[corner]);
        }
    }
    std::vector<HostMesh> meshes;
    for (const Object& object : objects)
        if (!object.corners.empty()) meshes.push_back(quantized(object));
    if (meshes.empty()) throw std::runtime_error(path + ": has no faces");
    return meshes;
}
