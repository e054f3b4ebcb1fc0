// SPDX-License-Identifier: MIT
#include "lixel/scene/gltf_nodes.h"

#include "lixel/scene/gltf_accessor.h"
#include "lixel/scene/input_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lixel::gltf {
namespace {

Vec3d readVec3(const JsonAt& source)
{
    const auto [x, y, z] = source.numbers<3>();
    return {x, y, z};
}

// Sixteen numbers, column after column; the last row must be 0 0 0 1 within rounding.
template <typename Numbers>
Mat4d affineFromColumns(const Numbers& c, const JsonAt& place)
{
    Mat4d a;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) a.m[i][j] = double(c[4 * j + i]);
    const Vec4d off = a.row(3) - Vec4d{0, 0, 0, 1};
    if (!(std::abs(off.x) + std::abs(off.y) + std::abs(off.z) + std::abs(off.w) < 1e-5))
        place.refuse("expected an affine matrix: elements 3, 7, 11, 15 must be 0, 0, 0, 1");
    a.setRow(3, {0, 0, 0, 1});
    return a;
}

NodeTransform readTransform(const JsonAt& node)
{
    NodeTransform transform;
    if (const auto matrix = node.find("matrix")) transform.matrix = affineFromColumns(matrix->numbers<16>(), *matrix);
    if (const auto translation = node.find("translation")) transform.translation = readVec3(*translation);
    if (const auto scale = node.find("scale")) transform.scale = readVec3(*scale);
    if (const auto rotation = node.find("rotation")) {
        const auto [x, y, z, w] = rotation->numbers<4>();
        const double norm = std::hypot(std::hypot(x, y), std::hypot(z, w));
        if (!(norm > 1e-6)) rotation->refuse("expected a unit quaternion");
        transform.rotation = (1 / norm) * Vec4d{x, y, z, w};
    }
    return transform;
}

int readLightReference(const JsonAt& node, std::size_t lightCount)
{
    const auto extensions = node.find("extensions");
    const auto punctual = extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
    return punctual ? punctual->require("light").index(lightCount, "lights") : -1;
}

std::optional<JsonAt> lightArray(const File& file)
{
    const auto extensions = file.root().find("extensions");
    const auto punctual = extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
    return punctual ? punctual->find("lights") : std::nullopt;
}

Node readNode(const File& file, const JsonAt& source, const std::vector<MeshRange>& meshes, std::size_t lightCount)
{
    Node node;
    node.name = source.textOr("name", "");
    node.parentFromNode = readTransform(source);
    const auto children = source.find("children");
    for (std::size_t c = 0; children && c < children->size(); ++c)
        node.children.push_back((*children)[c].index(file.count("nodes"), "nodes"));
    if (const int m = source.indexOr("mesh", meshes.size(), "meshes"); m >= 0) {
        node.meshes.resize(std::size_t(meshes[std::size_t(m)].count));
        std::iota(node.meshes.begin(), node.meshes.end(), meshes[std::size_t(m)].first);
    }
    const auto weights = source.find("weights");
    for (std::size_t w = 0; weights && w < weights->size(); ++w)
        node.morphWeights.push_back(float((*weights)[w].number()));
    node.skin = source.indexOr("skin", file.count("skins"), "skins");
    node.camera = source.indexOr("camera", file.count("cameras"), "cameras");
    node.light = readLightReference(source, lightCount);
    return node;
}

// Each node has one parent at most, and no node is below itself. Returns each one's parent, -1 for none.
std::vector<int> checkForest(const File& file, const std::vector<Node>& nodes)
{
    std::vector<int> parent(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const int child : nodes[i].children) {
            if (parent[std::size_t(child)] >= 0)
                file.element("nodes", child)
                    .refuse(fmt::format("expected one parent, found nodes[{}] and nodes[{}]",
                                        parent[std::size_t(child)], i));
            parent[std::size_t(child)] = int(i);
        }
    // With one parent each, whatever cannot be reached from a node without parent lies on or below a cycle.
    std::vector<int> open;
    std::size_t reached = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (parent[i] < 0) open.push_back(int(i));
    std::vector<bool> isReached(nodes.size(), false);
    while (!open.empty()) {
        const int i = open.back();
        open.pop_back();
        isReached[std::size_t(i)] = true, ++reached;
        const std::vector<int>& children = nodes[std::size_t(i)].children;
        open.insert(open.end(), children.begin(), children.end());
    }
    if (reached < nodes.size()) {
        const auto lost = std::find(isReached.begin(), isReached.end(), false) - isReached.begin();
        file.element("nodes", int(lost)).refuse("expected a tree of nodes, found a cycle");
    }
    return parent;
}

std::vector<int> readRoots(const File& file, const std::vector<int>& parent)
{
    std::vector<int> roots;
    if (file.count("scenes") == 0) {
        for (std::size_t i = 0; i < parent.size(); ++i)
            if (parent[i] < 0) roots.push_back(int(i));
        return roots;
    }
    const int chosen = file.root().indexOr("scene", file.count("scenes"), "scenes");
    const JsonAt scene = file.element("scenes", std::max(chosen, 0));
    const auto nodes = scene.find("nodes");
    std::vector<bool> isListed(parent.size(), false);
    for (std::size_t i = 0; nodes && i < nodes->size(); ++i) {
        const int root = (*nodes)[i].index(parent.size(), "nodes");
        if (parent[std::size_t(root)] >= 0 || isListed[std::size_t(root)])
            (*nodes)[i].refuse("expected a node without a parent, named once");
        isListed[std::size_t(root)] = true;
        roots.push_back(root);
    }
    return roots;
}

double readFar(const JsonAt& zfar, double near)
{
    const double far = zfar.number();
    if (!(far > near)) zfar.refuse(fmt::format("expected more than znear, {}, found {}", near, far));
    return far;
}

Camera readPerspective(const JsonAt& source)
{
    Camera camera;
    camera.fovy = source.require("yfov").number(1e-6, 3.14159);
    camera.near = source.require("znear").number(1e-30);
    if (const auto far = source.find("zfar")) camera.far = readFar(*far, camera.near);
    return camera;
}

Camera readOrthographic(const JsonAt& source)
{
    Camera camera;
    camera.orthographicHeight = 2 * std::abs(source.require("ymag").number());
    if (!(camera.orthographicHeight > 0)) source.require("ymag").refuse("expected a number that is not 0");
    camera.near = source.require("znear").number(0);
    camera.far = readFar(source.require("zfar"), camera.near);
    return camera;
}

Light readLight(const JsonAt& source)
{
    Light light;
    light.name = source.textOr("name", "light");
    light.directionWorld = {0, 0, -1};
    const JsonAt type = source.require("type");
    if (type.text() == "directional") light.kind = LightKind::Directional;
    else if (type.text() == "point") light.kind = LightKind::Point;
    else if (type.text() == "spot") light.kind = LightKind::Spot;
    else type.refuse(fmt::format("expected directional, point or spot, found '{}'", printable(type.text())));

    if (const auto range = source.find("range"); range && light.kind != LightKind::Directional)
        light.range = range->number(1e-30);
    if (light.kind == LightKind::Spot) {
        // The file may open the cone to a whole half-space; a shadow map's image plane cannot.
        constexpr double kHalfTurn = 3.141592653589793, kWidestCone = 0.999 * kHalfTurn;
        const double outer = source.require("spot").numberOr("outerConeAngle", kHalfTurn / 4, 1e-6, 1.5708);
        light.coneAngle = std::min(2 * outer, kWidestCone);
    }
    const double intensity = source.numberOr("intensity", 1, 0);
    const auto colour = source.find("color");
    light.colour = intensity * (colour ? readVec3(*colour) : Vec3d{1, 1, 1});
    return light;
}

double largestComponent(Vec3d colour) { return std::max({colour.x, colour.y, colour.z}); }

} // namespace

void readNodes(File& file, const std::vector<MeshRange>& meshes, Scene& scene)
{
    const auto lights = lightArray(file);
    for (std::size_t i = 0; i < file.count("nodes"); ++i)
        scene.nodes.push_back(readNode(file, file.element("nodes", int(i)), meshes, lights ? lights->size() : 0));
    scene.roots = readRoots(file, checkForest(file, scene.nodes));
}

void readSkins(File& file, Scene& scene)
{
    for (std::size_t s = 0; s < file.count("skins"); ++s) {
        const JsonAt source = file.element("skins", int(s));
        Skin skin;
        const JsonAt joints = source.require("joints");
        for (std::size_t j = 0; j < joints.size(); ++j)
            skin.joints.push_back(joints[j].index(scene.nodes.size(), "nodes"));
        skin.modelFromBindInverse.resize(skin.joints.size());
        if (const auto reference = source.find("inverseBindMatrices")) {
            const std::vector<float> numbers = Accessor(file, *reference).expect(16).floats();
            if (numbers.size() / 16 < skin.joints.size())
                reference->refuse(fmt::format("expected {} matrices, one a joint, found {}", skin.joints.size(),
                                              numbers.size() / 16));
            for (std::size_t j = 0; j < skin.joints.size(); ++j)
                skin.modelFromBindInverse[j] = affineFromColumns(std::span(numbers).subspan(16 * j, 16), *reference);
        }
        scene.skins.push_back(std::move(skin));
    }
}

void readCameras(File& file, Scene& scene)
{
    for (std::size_t i = 0; i < file.count("cameras"); ++i) {
        const JsonAt source = file.element("cameras", int(i));
        const JsonAt type = source.require("type");
        const bool isOrthographic = type.text() == "orthographic";
        if (!isOrthographic && type.text() != "perspective")
            type.refuse(fmt::format("expected perspective or orthographic, found '{}'", printable(type.text())));
        Camera camera = isOrthographic ? readOrthographic(source.require("orthographic"))
                                       : readPerspective(source.require("perspective"));
        camera.name = source.textOr("name", fmt::format("camera {}", i));
        scene.cameras.push_back(camera);
    }
}

void readLights(File& file, Scene& scene)
{
    const auto lights = lightArray(file);
    for (std::size_t i = 0; lights && i < lights->size(); ++i) scene.lights.push_back(readLight((*lights)[i]));

    double brightestLux = 0, brightestCandela = 0;
    const auto brightest = [&](const Light& light) -> double& {
        return light.kind == LightKind::Directional ? brightestLux : brightestCandela;
    };
    for (const Light& light : scene.lights)
        brightest(light) = std::max(brightest(light), largestComponent(light.colour));
    for (Light& light : scene.lights)
        if (brightest(light) > 0) light.colour = light.colour / brightest(light);
}

} // namespace lixel::gltf
