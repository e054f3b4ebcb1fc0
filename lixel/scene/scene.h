// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/box.h"
#include "lixel/base/caster_source.h"
#include "lixel/base/light.h"
#include "lixel/base/mat4.h"
#include "lixel/base/plane.h"
#include "lixel/base/surfaces.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// A scene as it comes from a file or a builder: meshes, nodes, materials, animation, cameras, lights and named views. It is
// evaluated at a time into floats that both executors draw (see evaluate.h).
namespace lixel {

// Positions in model space. A mesh holds one primitive of glTF: one material.
struct MorphTarget
{
    std::vector<Vec3f> position; // displacements, one a position; empty: none
    std::vector<Vec3f> normal;
};

struct Mesh
{
    std::vector<Vec3f> position;
    std::vector<Vec3f> normal;          // empty, or one a position
    std::vector<Vec2f> uv;              // empty, or one a position
    std::vector<Vec4f> colour;          // empty, or one a position; linear
    std::vector<std::uint32_t> indices; // triples
    std::vector<std::uint16_t> joints;  // empty, or `influences` a position
    std::vector<float> weights;         // likewise
    int influences = 0;                 // joints a position: 0, 4, 8, ...
    std::vector<MorphTarget> morphTargets;
    std::vector<float> defaultMorphWeights;
    int material = 0;
};

// Placement relative to the parent: T * R * S, or a matrix.
struct NodeTransform
{
    Vec3d translation{0, 0, 0};
    Vec4d rotation{0, 0, 0, 1}; // unit quaternion x, y, z, w
    Vec3d scale{1, 1, 1};
    std::optional<Mat4d> matrix; // takes the place of the other three
};

struct Node
{
    std::string name;
    NodeTransform parentFromNode;
    std::vector<int> children;
    std::vector<int> meshes; // into Scene::meshes
    int skin = -1;
    std::vector<float> morphWeights; // empty: the meshes' own
    int camera = -1, light = -1;     // into Scene::cameras, Scene::lights
};

struct Skin
{
    std::vector<int> joints;                 // nodes
    std::vector<Mat4d> modelFromBindInverse; // inverse bind matrices, one a joint (identity where the file has none)
};

enum class Interpolation { Step, Linear, CubicSpline };
enum class AnimationPath { Translation, Rotation, Scale, MorphWeights };

struct AnimationChannel
{
    int node = -1;
    AnimationPath path = AnimationPath::Translation;
    Interpolation interpolation = Interpolation::Linear;
    std::vector<float> time;  // seconds, ascending
    std::vector<float> value; // glTF's layout: per key the value, or for cubic splines in-tangent, value, out-tangent
};

struct Animation
{
    std::string name;
    std::vector<AnimationChannel> channels;
};

// A camera without a picture's size.
struct Camera
{
    std::string name;
    Vec3d eyeWorld, targetWorld{0, 0, -1}, up{0, 1, 0};
    double fovy = 0.8726646259971648;                     // radians
    double orthographicHeight = 0;                        // > 0: orthographic, world units
    double near = 0;                                      // 0: chosen from the scene's size
    double far = std::numeric_limits<double>::infinity(); // infinite: the scene's end
};

// A camera with lights, named: what `--view` picks. Built-in scenes have at least eight.
struct NamedView
{
    std::string name;
    std::string description;
    Camera camera;
    std::vector<Light> lights;
};

// Camera and light over time, linear between keys. A key's light point or direction replaces that of the first light.
struct PathKey
{
    double time = 0; // seconds
    Vec3d eyeWorld, targetWorld;
    std::optional<Vec3d> lightPositionWorld, lightDirectionWorld;
};

struct Scene
{
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Material> materials; // at least one
    std::vector<Texture> textures;
    std::vector<Node> nodes;
    std::vector<int> roots;
    std::vector<Skin> skins;
    std::vector<Animation> animations; // one of them plays, the first by default

    std::vector<Camera> cameras;    // of the file, in the space of their node
    std::vector<Light> lights;      // of the file, in the space of their node
    std::vector<NamedView> views;   // built-in scenes and view files
    std::vector<NamedPlane> planes; // named planes of interest
    std::vector<PathKey> path;

    std::vector<std::string> warnings; // lines about what the file has and we leave out

    // Built-in scenes move by their own rule: called before evaluation, sets node transforms for a time in seconds. It is
    // given a copy without meshes and textures.
    std::function<void(Scene&, double time)> animate;
};

} // namespace lixel
