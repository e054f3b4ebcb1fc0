// SPDX-License-Identifier: MIT
#include "lixel/scene/gltf_meshes.h"

#include "lixel/scene/check_scene.h"
#include "lixel/scene/gltf_accessor.h"
#include "lixel/scene/input_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <numeric>

namespace lixel::gltf {
namespace {

// The order in which glTF draws the corners of triangles (section 3.7.2.1).
enum class Mode { Triangles = 4, TriangleStrip, TriangleFan };

std::vector<std::uint32_t> asTriangles(const std::vector<std::uint32_t>& corners, Mode mode)
{
    const std::size_t n = corners.size();
    if (mode == Mode::Triangles) return {corners.begin(), corners.begin() + std::ptrdiff_t(n / 3 * 3)};
    std::vector<std::uint32_t> triangles;
    triangles.reserve(n < 3 ? 0 : (n - 2) * 3);
    for (std::size_t i = 0; i + 2 < n; ++i) {
        const bool isOdd = i % 2 == 1;
        if (mode == Mode::TriangleStrip)
            triangles.insert(triangles.end(), {corners[i], corners[i + (isOdd ? 2 : 1)], corners[i + (isOdd ? 1 : 2)]});
        else triangles.insert(triangles.end(), {corners[i + 1], corners[i + 2], corners[0]});
    }
    return triangles;
}

// Keeps only used vertices: several primitives often share one large array. Indices are changed to count those kept;
// returns them, or nothing where all are used.
std::vector<std::uint32_t> dropUnused(std::vector<std::uint32_t>& indices, std::size_t vertexCount)
{
    const auto [least, most] = std::minmax_element(indices.begin(), indices.end());
    const std::uint32_t first = *least;
    std::vector<std::uint32_t> place(*most - first + 1, 0);
    for (const std::uint32_t i : indices) place[i - first] = 1;
    const std::size_t used = std::size_t(std::accumulate(place.begin(), place.end(), std::uint64_t(0)));
    if (used == vertexCount) return {};
    std::vector<std::uint32_t> kept;
    kept.reserve(used);
    for (std::uint32_t i = 0; i < place.size(); ++i)
        if (place[i] != 0) {
            place[i] = std::uint32_t(kept.size());
            kept.push_back(first + i);
        }
    for (std::uint32_t& i : indices) i = place[i - first];
    return kept;
}

template <typename T>
std::vector<T> grouped(const std::vector<float>& values)
{
    static_assert(sizeof(T) % sizeof(float) == 0);
    std::vector<T> groups(values.size() * sizeof(float) / sizeof(T));
    if (!groups.empty()) std::memcpy(static_cast<void*>(groups.data()), values.data(), values.size() * sizeof(float));
    return groups;
}

// One primitive on its way to a Mesh.
class Primitive
{
public:
    Primitive(File& file, const JsonAt& primitive, const UvSource& uvSource)
        : file_(file), primitive_(primitive), attributes_(primitive.require("attributes")), uvSource_(uvSource)
    {
    }

    // Nothing where it draws no triangle.
    std::optional<Mesh> read()
    {
        const std::size_t mode = primitive_.integerOr("mode", 4, 0, 6);
        const auto position = attributes_.find("POSITION");
        if (mode < 4 || !position) {
            file_.warnings.push_back(
                fmt::format("{}: {}: {} left out", file_.name(), primitive_.place(),
                            position ? "points and lines are" : "a primitive without POSITION is"));
            return std::nullopt;
        }
        const Accessor positions(file_, *position);
        vertexCount_ = positions.expect(3).count();
        mesh_.indices = asTriangles(corners(), Mode(mode));
        if (mesh_.indices.empty()) return std::nullopt;
        kept_ = dropUnused(mesh_.indices, vertexCount_);
        mesh_.position = grouped<Vec3f>(positions.floats(kept_));
        mesh_.normal = grouped<Vec3f>(attribute(attributes_, "NORMAL", 3));
        readUv();
        readColour();
        readInfluences();
        readMorphTargets();
        return std::move(mesh_);
    }

private:
    std::vector<std::uint32_t> corners()
    {
        const auto reference = primitive_.find("indices");
        const auto expectAtMost = [&](std::size_t most, std::size_t found) { // before they are read
            if (found > most)
                primitive_.refuse(fmt::format("expected at most {} triangles and vertices in all", kMostDrawn));
        };
        if (!reference) {
            expectAtMost(kMostDrawn, vertexCount_);
            file_.spend(vertexCount_ * sizeof(std::uint32_t), primitive_);
            std::vector<std::uint32_t> all(vertexCount_);
            std::iota(all.begin(), all.end(), 0u);
            return all;
        }
        const Accessor accessor(file_, *reference);
        expectAtMost(3 * kMostDrawn, accessor.count());
        std::vector<std::uint32_t> indices = accessor.expect(1).integers();
        const auto most = std::max_element(indices.begin(), indices.end());
        if (*most >= vertexCount_)
            reference->refuse(
                fmt::format("expected indices below {}, the number of vertices, found {}", vertexCount_, *most));
        return indices;
    }

    std::optional<Accessor> accessor(const JsonAt& attributes, const char* name)
    {
        const auto reference = attributes.find(name);
        if (!reference) return std::nullopt;
        Accessor found(file_, *reference);
        if (found.count() != vertexCount_)
            reference->refuse(fmt::format("expected {} elements, one a vertex, found {}", vertexCount_, found.count()));
        return found;
    }

    // Empty where there is none.
    std::vector<float> attribute(const JsonAt& attributes, const char* name, std::size_t components)
    {
        const auto found = accessor(attributes, name);
        return found ? found->expect(components).floats(kept_) : std::vector<float>{};
    }

    void readUv()
    {
        const std::string name = fmt::format("TEXCOORD_{}", uvSource_.set);
        mesh_.uv = grouped<Vec2f>(attribute(attributes_, name.c_str(), 2));
        if (uvSource_.isIdentity) return;
        for (Vec2f& uv : mesh_.uv)
            uv =
                toFloat(uvSource_.offset + Vec2d{dot(uvSource_.rowU, toDouble(uv)), dot(uvSource_.rowV, toDouble(uv))});
    }

    void readColour()
    {
        const auto colours = accessor(attributes_, "COLOR_0");
        if (!colours) return;
        if (colours->components() != 3) {
            mesh_.colour = grouped<Vec4f>(colours->expect(4).floats(kept_));
            return;
        }
        for (const Vec3f& c : grouped<Vec3f>(colours->floats(kept_))) mesh_.colour.push_back({c.x, c.y, c.z, 1});
    }

    // JOINTS_n and WEIGHTS_n, four of each, side by side for each vertex.
    void readInfluences()
    {
        std::vector<std::vector<std::uint32_t>> joints;
        std::vector<std::vector<float>> weights;
        for (std::size_t set = 0; set < 16; ++set) {
            const auto j = accessor(attributes_, fmt::format("JOINTS_{}", set).c_str());
            const auto w = accessor(attributes_, fmt::format("WEIGHTS_{}", set).c_str());
            if (j.has_value() != w.has_value())
                attributes_.refuse(fmt::format("expected JOINTS_{0} and WEIGHTS_{0} together", set));
            if (!j) break;
            joints.push_back(j->expect(4).integers(kept_));
            weights.push_back(w->expect(4).floats(kept_));
        }
        mesh_.influences = int(4 * joints.size());
        const std::size_t count = joints.empty() ? 0 : mesh_.position.size();
        for (std::size_t v = 0; v < count; ++v)
            for (std::size_t i = 0; i < 4 * joints.size(); ++i) {
                const std::uint32_t joint = joints[i / 4][4 * v + i % 4];
                const float weight = weights[i / 4][4 * v + i % 4];
                if (weight < 0)
                    attributes_.refuse(fmt::format("expected WEIGHTS_{} of 0 or more, found {}", i / 4, weight));
                // The joint of a weight of zero means nothing, and files put anything there.
                if (weight > 0 && joint > 65535)
                    attributes_.refuse(fmt::format("expected JOINTS_{} up to 65535, found {}", i / 4, joint));
                mesh_.joints.push_back(weight > 0 ? std::uint16_t(joint) : std::uint16_t(0));
                mesh_.weights.push_back(weight);
            }
    }

    void readMorphTargets()
    {
        const auto targets = primitive_.find("targets");
        for (std::size_t i = 0; targets && i < targets->size(); ++i) {
            const JsonAt target = (*targets)[i];
            mesh_.morphTargets.push_back(
                {grouped<Vec3f>(attribute(target, "POSITION", 3)), grouped<Vec3f>(attribute(target, "NORMAL", 3))});
        }
    }

    File& file_;
    const JsonAt primitive_, attributes_;
    const UvSource& uvSource_;
    std::size_t vertexCount_ = 0;
    std::vector<std::uint32_t> kept_; // empty: all
    Mesh mesh_;
};

std::vector<float> readWeights(const JsonAt& mesh)
{
    std::vector<float> weights;
    const auto array = mesh.find("weights");
    for (std::size_t i = 0; array && i < array->size(); ++i) weights.push_back(float((*array)[i].number()));
    return weights;
}

} // namespace

std::vector<MeshRange> readMeshes(File& file, const std::vector<UvSource>& uvSources, Scene& scene)
{
    std::vector<MeshRange> ranges;
    for (std::size_t m = 0; m < file.count("meshes"); ++m) {
        const JsonAt source = file.element("meshes", int(m));
        MeshRange range{int(scene.meshes.size()), 0};
        const JsonAt primitives = source.require("primitives");
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            const JsonAt primitive = primitives[p];
            const int named = primitive.indexOr("material", file.count("materials"), "materials");
            const int material = named < 0 ? int(uvSources.size()) - 1 : named; // the last is glTF's default
            std::optional<Mesh> mesh = Primitive(file, primitive, uvSources[std::size_t(material)]).read();
            if (!mesh) continue;
            mesh->material = material;
            mesh->defaultMorphWeights = readWeights(source);
            scene.meshes.push_back(*std::move(mesh));
            ++range.count;
        }
        ranges.push_back(range);
    }
    return ranges;
}

} // namespace lixel::gltf
