// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

// Short ways to put a built-in scene together.
namespace lixel::builtin {

Scene emptyScene(std::string name);

// Colours are given as on a web page, 0xRRGGBB in sRGB.
Vec4f linearColour(std::uint32_t srgb);

int addMaterial(Scene& scene, std::uint32_t srgb);
int addTextured(Scene& scene, Texture texture);
int addMasked(Scene& scene, Texture texture); // kept where the texture's alpha is at least one half
int addMesh(Scene& scene, Mesh mesh, int material);

struct Placement
{
    Vec3d position;
    double turnDegrees = 0; // about Y
    Vec3d scale{1, 1, 1};
};

NodeTransform transformOf(const Placement& placement);
int addNode(Scene& scene, std::string name, std::vector<int> meshes, const Placement& placement = {});

// Adds a mesh that is placed once, where it already is.
int addStatic(Scene& scene, std::string name, Mesh mesh, int material);

Camera lookAt(Vec3d eyeWorld, Vec3d targetWorld, double fovyDegrees = 50);
Light sun(Vec3d directionWorld, std::string name = "sun");
Light lamp(Vec3d positionWorld, std::string name = "lamp");
Light spot(Vec3d positionWorld, Vec3d targetWorld, double coneDegrees, std::string name = "spot");
Light tinted(Light light, Vec3d colour);

void addView(Scene& scene, std::string name, std::string description, const Camera& camera, std::vector<Light> lights);
void addPlane(Scene& scene, std::string name, Vec3d pointWorld, Vec3d normalWorld,
              std::vector<Vec3d> polygonWorld = {});

// Keys of a camera path at equal steps of time, with the place or the direction of its light.
struct Waypoint
{
    Vec3d eyeWorld, targetWorld, light;
};
void addPath(Scene& scene, LightKind kind, double secondsApart, const std::vector<Waypoint>& waypoints);

} // namespace lixel::builtin
