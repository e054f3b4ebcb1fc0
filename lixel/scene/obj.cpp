// SPDX-License-Identifier: MIT
#include "lixel/scene/check_scene.h"
#include "lixel/scene/input_file.h"
#include "lixel/scene/load.h"
#include "lixel/scene/obj_materials.h"
#include "lixel/scene/obj_text.h"
#include "lixel/scene/triangulate.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <array>
#include <filesystem>
#include <iterator>
#include <map>
#include <new>
#include <set>
#include <sstream>
#include <unordered_map>

namespace lixel {
namespace {

// One corner of a face: position, uv, normal, counted from 0; -1 where it has none.
using Corner = std::array<int, 3>;

struct CornerHash
{
    std::size_t operator()(const Corner& c) const
    {
        std::uint64_t hash = 0;
        for (const int part : c) hash = (hash ^ std::uint64_t(part + 1)) * 0x9e3779b97f4a7c15u;
        return std::size_t(hash ^ hash >> 32);
    }
};

// The faces of one group that have one material: they become one mesh and its node.
struct Part
{
    std::string group;
    int material = 0;
    std::vector<Corner> corners;
    std::vector<std::size_t> faceSizes;
};

// What tinyobjloader reads, kept as it comes: faces may name vertices that stand further down.
class Faces
{
public:
    Faces(const std::string& text, const obj::Materials& materials) : materials_(materials)
    {
        tinyobj::callback_t call;
        call.vertex_cb = [](void* to, float x, float y, float z, float) { self(to).positions.push_back({x, y, z}); };
        call.texcoord_cb = [](void* to, float u, float v, float) { self(to).uvs.push_back({u, v}); };
        call.normal_cb = [](void* to, float x, float y, float z) { self(to).normals.push_back({x, y, z}); };
        call.index_cb = [](void* to, tinyobj::index_t* corners, int count) {
            self(to).addFace({corners, std::size_t(count)});
        };
        call.usemtl_cb = [](void* to, const char* name, int) { self(to).useMaterial(name); };
        call.group_cb = [](void* to, const char** names, int count) { self(to).startGroup(count > 0 ? names[0] : ""); };
        call.object_cb = [](void* to, const char* name) { self(to).startGroup(name); };
        std::istringstream stream(text);
        std::string warning, error;
        tinyobj::LoadObjWithCallback(stream, call, this, nullptr, &warning, &error);
    }

    std::vector<Vec3f> positions, normals;
    std::vector<Vec2f> uvs;
    std::vector<Part> parts;
    std::size_t facesLeftOut = 0;
    std::string unknownMaterial; // the first that no MTL file has

private:
    static Faces& self(void* to) { return *static_cast<Faces*>(to); }

    // OBJ counts from 1, or backwards from the last where negative; 0 stands for none.
    static int fromZero(int index, std::size_t count)
    {
        return index > 0 ? index - 1 : index < 0 ? int(count) + index : -1;
    }

    void addFace(std::span<const tinyobj::index_t> corners)
    {
        if (corners.size() < 3) {
            ++facesLeftOut;
            return;
        }
        const auto [place, isNew] = partOf_.try_emplace({group_, material_}, parts.size());
        if (isNew) parts.push_back({groupName_, material_, {}, {}});
        Part& part = parts[place->second];
        for (const tinyobj::index_t& c : corners)
            part.corners.push_back({fromZero(c.vertex_index, positions.size()), fromZero(c.texcoord_index, uvs.size()),
                                    fromZero(c.normal_index, normals.size())});
        part.faceSizes.push_back(corners.size());
    }

    void useMaterial(std::string_view name)
    {
        const auto found = materials_.byName.find(name);
        material_ = found == materials_.byName.end() ? 0 : found->second;
        if (material_ == 0 && unknownMaterial.empty()) unknownMaterial = name;
    }

    void startGroup(std::string_view name) { ++group_, groupName_ = printable(name); }

    const obj::Materials& materials_;
    std::map<std::pair<int, int>, std::size_t> partOf_; // of a group's number and a material
    int group_ = 0, material_ = 0;
    std::string groupName_;
};

// Triangles of a part, each different corner once. Normals are kept where every corner has one.
Mesh buildMesh(const Faces& faces, const Part& part, const obj::UvTransform& uvTransform)
{
    Mesh mesh;
    mesh.material = part.material;
    bool anyUv = false, allNormals = true;
    for (const Corner& c : part.corners) anyUv |= c[1] >= 0, allNormals &= c[2] >= 0;

    std::unordered_map<Corner, std::uint32_t, CornerHash> known;
    const auto vertex = [&](const Corner& c) {
        const auto [place, isNew] = known.try_emplace(c, std::uint32_t(mesh.position.size()));
        if (!isNew) return place->second;
        mesh.position.push_back(faces.positions.at(std::size_t(c[0])));
        if (allNormals) mesh.normal.push_back(faces.normals.at(std::size_t(c[2])));
        if (anyUv) {
            const Vec2d uv = c[1] < 0 ? Vec2d{} : toDouble(faces.uvs.at(std::size_t(c[1])));
            mesh.uv.push_back(
                toFloat(Vec2d{uvTransform.scale.x * uv.x, uvTransform.scale.y * uv.y} + uvTransform.offset));
        }
        return place->second;
    };
    std::size_t first = 0;
    std::vector<Vec3d> polygon;
    std::vector<std::uint32_t> triangles;
    for (const std::size_t size : part.faceSizes) {
        polygon.clear(), triangles.clear();
        for (std::size_t i = first; i < first + size; ++i)
            polygon.push_back(toDouble(faces.positions.at(std::size_t(part.corners[i][0]))));
        triangulatePolygon(polygon, triangles);
        for (const std::uint32_t i : triangles) mesh.indices.push_back(vertex(part.corners[first + i]));
        first += size;
    }
    return mesh;
}

bool isThere(const std::filesystem::path& path)
{
    std::error_code ignored; // a name may be no path at all
    return std::filesystem::exists(path, ignored);
}

// What mtllib names: one file, spaces and all, if there is such a one, else several.
std::vector<std::string> fileNames(const std::string& names, const std::string& baseDirectory)
{
    if (names.find(' ') == names.npos || isThere(std::filesystem::path(baseDirectory) / names)) return {names};
    std::istringstream words(names);
    return {std::istream_iterator<std::string>(words), {}};
}

// A material file that is missing costs the colours, not the scene.
obj::Materials readMaterials(const obj::CheckedText& checked, const std::string& name, const std::string& baseDirectory,
                             Scene& scene)
{
    obj::Materials materials;
    scene.materials.emplace_back(); // grey
    materials.uv.emplace_back();
    std::set<std::string> read; // whatever ways lead to them
    for (const std::string& names : checked.materialFiles)
        for (const std::string& file : fileNames(names, baseDirectory)) {
            std::error_code error;
            const auto path = std::filesystem::weakly_canonical(std::filesystem::path(baseDirectory) / file, error);
            if (!read.insert(error ? file : path.string()).second) continue;
            try {
                InputBytes bytes = openNeighbour(baseDirectory, file, name, "mtllib");
                const std::string shown = printable(file);
                const std::string text = bytes.readText(0, bytes.size(), shown, "expected MTL text, found a zero byte");
                obj::readMtl(text, shown, baseDirectory, scene, materials);
            } catch (const InputError& problem) {
                scene.warnings.push_back(fmt::format("{}; its materials are grey", problem.what()));
            }
        }
    return materials;
}

} // namespace

Scene loadObj(InputBytes& bytes, const std::string& name, const std::string& baseDirectory)
{
    try {
        const obj::CheckedText checked = obj::checkObj(bytes, name);
        Scene scene;
        scene.name = sceneName(name);
        const obj::Materials materials = readMaterials(checked, name, baseDirectory, scene);
        const Faces faces(checked.text, materials);
        for (const Part& part : faces.parts) {
            Node node;
            node.name = part.group;
            node.meshes = {int(scene.meshes.size())};
            scene.roots.push_back(int(scene.nodes.size()));
            scene.nodes.push_back(std::move(node));
            scene.meshes.push_back(buildMesh(faces, part, materials.uv.at(std::size_t(part.material))));
        }
        if (faces.facesLeftOut > 0)
            scene.warnings.push_back(
                fmt::format("{}: {} faces with fewer than 3 corners are left out", name, faces.facesLeftOut));
        if (!faces.unknownMaterial.empty() && scene.materials.size() > 1)
            scene.warnings.push_back(
                fmt::format("{}: material '{}' is not known; grey", name, printable(faces.unknownMaterial)));
        checkScene(scene, name);
        return scene;
    } catch (const std::bad_alloc&) {
        refuse(name, "", "expected a scene that fits into memory");
    }
}

} // namespace lixel
