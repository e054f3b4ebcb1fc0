// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/assemble.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace lixel::builtin {

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

float linear(std::uint32_t byte)
{
    const double s = double(byte & 0xff) / 255;
    return float(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

int addMaterial(Scene& scene, Material material)
{
    scene.materials.push_back(material);
    return int(scene.materials.size()) - 1;
}

} // namespace

Scene emptyScene(std::string name)
{
    Scene scene;
    scene.name = std::move(name);
    return scene;
}

Vec4f linearColour(std::uint32_t srgb) { return {linear(srgb >> 16), linear(srgb >> 8), linear(srgb), 1}; }

int addMaterial(Scene& scene, std::uint32_t srgb)
{
    Material material;
    material.baseColour = linearColour(srgb);
    return addMaterial(scene, material);
}

int addTextured(Scene& scene, Texture texture)
{
    Material material;
    material.baseColour = {1, 1, 1, 1};
    material.texture = int(scene.textures.size());
    scene.textures.push_back(std::move(texture));
    return addMaterial(scene, material);
}

int addMasked(Scene& scene, Texture texture)
{
    const int index = addTextured(scene, std::move(texture));
    scene.materials[std::size_t(index)].alphaMode = AlphaMode::Mask;
    scene.materials[std::size_t(index)].doubleSided = true;
    return index;
}

int addMesh(Scene& scene, Mesh mesh, int material)
{
    mesh.material = material;
    scene.meshes.push_back(std::move(mesh));
    return int(scene.meshes.size()) - 1;
}

NodeTransform transformOf(const Placement& placement)
{
    const double half = radians(placement.turnDegrees) / 2;
    NodeTransform transform;
    transform.translation = placement.position;
    transform.rotation = {0, std::sin(half), 0, std::cos(half)};
    transform.scale = placement.scale;
    return transform;
}

int addNode(Scene& scene, std::string name, std::vector<int> meshes, const Placement& placement)
{
    Node node;
    node.name = std::move(name);
    node.meshes = std::move(meshes);
    node.parentFromNode = transformOf(placement);
    scene.nodes.push_back(std::move(node));
    const int index = int(scene.nodes.size()) - 1;
    scene.roots.push_back(index);
    return index;
}

int addStatic(Scene& scene, std::string name, Mesh mesh, int material)
{
    return addNode(scene, std::move(name), {addMesh(scene, std::move(mesh), material)});
}

Camera lookAt(Vec3d eyeWorld, Vec3d targetWorld, double fovyDegrees)
{
    Camera camera;
    camera.eyeWorld = eyeWorld;
    camera.targetWorld = targetWorld;
    camera.fovy = radians(fovyDegrees);
    return camera;
}

Light sun(Vec3d directionWorld, std::string name)
{
    Light light;
    light.name = std::move(name);
    light.directionWorld = normalized(directionWorld);
    return light;
}

Light lamp(Vec3d positionWorld, std::string name)
{
    Light light;
    light.name = std::move(name);
    light.kind = LightKind::Point;
    light.positionWorld = positionWorld;
    return light;
}

Light spot(Vec3d positionWorld, Vec3d targetWorld, double coneDegrees, std::string name)
{
    Light light;
    light.name = std::move(name);
    light.kind = LightKind::Spot;
    light.positionWorld = positionWorld;
    light.directionWorld = normalized(targetWorld - positionWorld);
    light.coneAngle = radians(coneDegrees);
    return light;
}

Light tinted(Light light, Vec3d colour)
{
    light.colour = colour;
    return light;
}

void addView(Scene& scene, std::string name, std::string description, const Camera& camera, std::vector<Light> lights)
{
    NamedView view{std::move(name), std::move(description), camera, std::move(lights)};
    view.camera.name = view.name;
    scene.views.push_back(std::move(view));
}

void addPlane(Scene& scene, std::string name, Vec3d pointWorld, Vec3d normalWorld, std::vector<Vec3d> polygonWorld)
{
    scene.planes.push_back({std::move(name), pointWorld, normalWorld, std::move(polygonWorld)});
}

void addPath(Scene& scene, LightKind kind, double secondsApart, const std::vector<Waypoint>& waypoints)
{
    for (const Waypoint& waypoint : waypoints) {
        PathKey key;
        key.time = secondsApart * double(scene.path.size());
        key.eyeWorld = waypoint.eyeWorld;
        key.targetWorld = waypoint.targetWorld;
        if (kind == LightKind::Directional) key.lightDirectionWorld = normalized(waypoint.light);
        else key.lightPositionWorld = waypoint.light;
        scene.path.push_back(key);
    }
}

} // namespace lixel::builtin
