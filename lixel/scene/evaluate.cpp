// SPDX-License-Identifier: MIT
#include "lixel/scene/evaluate.h"

#include "lixel/base/assert.h"
#include "lixel/scene/content_hash.h"
#include "lixel/scene/deform.h"
#include "lixel/scene/pose.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lixel {
namespace {

// Beyond this a float's square is no number; what animation drives there is not drawn.
constexpr double kMostCoordinate = 1e30;

bool isDrawable(Vec3d p)
{
    return std::abs(p.x) <= kMostCoordinate && std::abs(p.y) <= kMostCoordinate && std::abs(p.z) <= kMostCoordinate;
}

// What moves: the scene without its meshes and textures, as Scene::animate leaves it.
Scene moved(const Scene& scene, double time)
{
    Scene copy;
    copy.name = scene.name;
    copy.nodes = scene.nodes, copy.roots = scene.roots, copy.skins = scene.skins;
    copy.animations = scene.animations, copy.materials = scene.materials;
    copy.cameras = scene.cameras, copy.lights = scene.lights;
    copy.views = scene.views, copy.planes = scene.planes, copy.path = scene.path;
    scene.animate(copy, time);
    return copy;
}

// Calls `visit(scene, pose)` with the scene at its time.
template <typename Visit>
void atTime(const Scene& scene, const EvaluateOptions& options, Visit visit)
{
    LX_ASSERT(std::isfinite(options.time));
    if (!scene.animate) return visit(scene, poseAt(scene, options));
    const Scene copy = moved(scene, options.time);
    visit(copy, poseAt(copy, options));
}

bool hasArea(Vec3f a, Vec3f b, Vec3f c)
{
    const Vec3d ab = toDouble(b) - toDouble(a), ac = toDouble(c) - toDouble(a);
    return cross(ab, ac) != Vec3d{};
}

// Puts placed meshes one after another.
class Flattener
{
public:
    Flattener(const Scene& meshesOf, Vec3d originWorld) : scene_(meshesOf)
    {
        out.originWorld = originWorld;
        for (const Mesh& mesh : scene_.meshes)
            anyNormal_ |= !mesh.normal.empty(), anyUv_ |= !mesh.uv.empty(), anyColour_ |= !mesh.colour.empty();
    }

    void reserve(std::size_t positions, std::size_t indices)
    {
        LX_ASSERT(positions < std::numeric_limits<std::uint32_t>::max());
        out.positionLocal.reserve(positions);
        out.normal.reserve(anyNormal_ ? positions : 0);
        out.uv.reserve(anyUv_ ? positions : 0);
        out.colour.reserve(anyColour_ ? positions : 0);
        out.indices.reserve(indices);
        out.material.reserve(indices / 3);
    }

    // Returns the box, in world space, of the triangles that are kept.
    Box add(const Mesh& mesh, const PlacedMesh& placed)
    {
        const auto first = std::uint32_t(out.positionLocal.size());
        bool allDrawable = true;
        for (const Vec3d& p : placed.positionLocal) {
            allDrawable &= isDrawable(p);
            out.positionLocal.push_back(isDrawable(p) ? toFloat(p) : Vec3f{});
        }
        append(out.normal, placed.normal, anyNormal_, Vec3f{});
        append(out.uv, mesh.uv, anyUv_, Vec2f{});
        append(out.colour, mesh.colour, anyColour_, Vec4f{1, 1, 1, 1});

        // A triangle without area in its model has none anywhere, though rounding may give it some.
        const bool isRigid = mesh.influences == 0 && mesh.morphTargets.empty();
        Box boxLocal;
        for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
            const std::uint32_t i = mesh.indices[t], j = mesh.indices[t + 1], k = mesh.indices[t + 2];
            if (!allDrawable && !(isDrawable(placed.positionLocal[i]) && isDrawable(placed.positionLocal[j]) &&
                                  isDrawable(placed.positionLocal[k])))
                continue;
            const Vec3f a = out.positionLocal[first + i], b = out.positionLocal[first + j],
                        c = out.positionLocal[first + k];
            if (!hasArea(a, b, c)) continue;
            if (isRigid && !hasArea(mesh.position[i], mesh.position[j], mesh.position[k])) continue;
            out.indices.insert(out.indices.end(), {first + i, first + j, first + k});
            out.material.push_back(std::uint32_t(mesh.material));
            boxLocal.include(toDouble(a)), boxLocal.include(toDouble(b)), boxLocal.include(toDouble(c));
        }
        return translated(boxLocal, out.originWorld);
    }

    LocalTriangles out;

private:
    template <typename T>
    void append(std::vector<T>& all, const std::vector<T>& some, bool isWanted, T missing)
    {
        if (!isWanted) return;
        all.insert(all.end(), some.begin(), some.end());
        all.resize(out.positionLocal.size(), missing);
    }

    const Scene& scene_;
    bool anyNormal_ = false, anyUv_ = false, anyColour_ = false;
};

// Scale of a node does not reach its camera and light (glTF 2.0, section 3.10; KHR_lights_punctual). Nothing where the
// node has lost a direction.
std::optional<Camera> inWorld(const Camera& camera, const Mat4d& worldFromNode)
{
    const Vec3d forward = normalized(transformDirection(worldFromNode, camera.targetWorld - camera.eyeWorld));
    const Vec3d sideways = cross(forward, transformDirection(worldFromNode, camera.up));
    Camera placed = camera;
    placed.eyeWorld = transformPoint(worldFromNode, camera.eyeWorld);
    placed.up = normalized(cross(sideways, forward));
    placed.targetWorld = placed.eyeWorld + forward;
    const bool hasDirections =
        length(forward) > 0.5 && length(placed.up) > 0.5 && placed.targetWorld != placed.eyeWorld;
    return hasDirections && isFinite(placed.targetWorld) && isFinite(placed.up) ? std::optional(placed) : std::nullopt;
}

std::optional<Light> inWorld(const Light& light, const Mat4d& worldFromNode)
{
    Light placed = light;
    placed.positionWorld = transformPoint(worldFromNode, light.positionWorld);
    placed.directionWorld = normalized(transformDirection(worldFromNode, light.directionWorld));
    const bool hasDirection = light.kind == LightKind::Point || length(placed.directionWorld) > 0.5;
    return hasDirection && isFinite(placed.positionWorld) && isFinite(placed.directionWorld) ? std::optional(placed)
                                                                                             : std::nullopt;
}

void placeCamerasAndLights(const Scene& scene, const Pose& pose, const std::vector<int>& nodes, SceneBuffers& out)
{
    for (const int n : nodes) {
        const Node& node = scene.nodes[std::size_t(n)];
        const Mat4d& worldFromNode = pose.worldFromNode[std::size_t(n)];
        if (node.camera >= 0)
            if (const auto camera = inWorld(scene.cameras[std::size_t(node.camera)], worldFromNode))
                out.cameras.push_back(*camera);
        if (node.light >= 0)
            if (const auto light = inWorld(scene.lights[std::size_t(node.light)], worldFromNode))
                out.lights.push_back(*light);
    }
}

} // namespace

Box sceneBounds(const Scene& scene, const EvaluateOptions& options)
{
    Box box;
    atTime(scene, options, [&](const Scene& posed, const Pose& pose) {
        for (const int n : drawnNodes(posed))
            for (const int m : posed.nodes[std::size_t(n)].meshes)
                for (const Vec3d& p : placeMesh(posed, pose, n, scene.meshes[std::size_t(m)], {}).positionLocal)
                    if (isDrawable(p)) box.include(p);
    });
    return box;
}

SceneBuffers evaluate(std::shared_ptr<const Scene> scene, const EvaluateOptions& options, Vec3d originWorld)
{
    LX_ASSERT(scene && isFinite(originWorld));
    SceneBuffers out;
    atTime(*scene, options, [&](const Scene& posed, const Pose& pose) {
        const std::vector<int> nodes = drawnNodes(posed);
        std::size_t positions = 0, indices = 0;
        for (const int n : nodes)
            for (const int m : posed.nodes[std::size_t(n)].meshes)
                positions += scene->meshes[std::size_t(m)].position.size(),
                    indices += scene->meshes[std::size_t(m)].indices.size();

        Flattener flattener(*scene, originWorld);
        flattener.reserve(positions, indices);
        for (const int n : nodes) {
            Box box;
            for (const int m : posed.nodes[std::size_t(n)].meshes) {
                const Mesh& mesh = scene->meshes[std::size_t(m)];
                box.include(flattener.add(mesh, placeMesh(posed, pose, n, mesh, originWorld)));
            }
            if (!box.isEmpty()) out.bounds.boxesWorld.push_back(box);
        }
        out.triangles = std::move(flattener.out);
        placeCamerasAndLights(posed, pose, nodes, out);
    });
    out.version = contentHash(out.triangles, *scene);
    out.scene = std::move(scene);
    return out;
}

CasterBuffers SceneBuffers::casters() const
{
    CasterMesh mesh;
    mesh.positions = triangles.positionLocal;
    mesh.indices = triangles.indices;
    mesh.uv = triangles.uv;
    mesh.colour = triangles.colour;
    mesh.normals = triangles.normal;
    mesh.material = triangles.material;
    CasterBuffers all;
    all.originWorld = triangles.originWorld;
    if (!triangles.indices.empty()) all.meshes.push_back(mesh); // no indices would mean: positions are triples
    all.materials = scene->materials;
    all.textures = scene->textures;
    all.version = version;
    return all;
}

Vec3d chooseOrigin(Vec3d eyeWorld, const Box& sceneWorld)
{
    LX_ASSERT(isFinite(eyeWorld));
    const double diagonal = sceneWorld.diagonal();
    if (!(diagonal > 0) || !std::isfinite(diagonal)) return eyeWorld;

    // An eye far outside would take the scene's own floats their precision: no farther than a scene's size from its
    // box.
    const auto near = [&](double eye, double min, double max) {
        return std::clamp(eye, min - diagonal, max + diagonal);
    };
    const Vec3d anchor{near(eyeWorld.x, sceneWorld.min.x, sceneWorld.max.x),
                       near(eyeWorld.y, sceneWorld.min.y, sceneWorld.max.y),
                       near(eyeWorld.z, sceneWorld.min.z, sceneWorld.max.z)};
    // A power of two, so that grid points are exact.
    const double step = std::exp2(std::floor(std::log2(diagonal / 4)));
    return {std::round(anchor.x / step) * step, std::round(anchor.y / step) * step, std::round(anchor.z / step) * step};
}

} // namespace lixel
