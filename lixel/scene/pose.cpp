// SPDX-License-Identifier: MIT
#include "lixel/scene/pose.h"

#include "lixel/base/assert.h"
#include "lixel/scene/animation.h"

#include <algorithm>
#include <array>

namespace lixel {
namespace {

// Depth first without recursion: files may have chains of any length.
std::vector<int> nodesBelow(const Scene& scene, const std::vector<int>& roots)
{
    std::vector<int> order, open(roots.rbegin(), roots.rend());
    while (!open.empty()) {
        const int i = open.back();
        open.pop_back();
        order.push_back(i);
        LX_ASSERT(order.size() <= scene.nodes.size()); // more: not a forest
        const std::vector<int>& children = scene.nodes[std::size_t(i)].children;
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return order;
}

// All nodes are placed, also those outside the scene that is drawn: a skin's joints may be anywhere.
std::vector<Mat4d> placeNodes(const Scene& scene, const std::vector<NodeTransform>& parentFromNode)
{
    std::vector<bool> hasParent(scene.nodes.size(), false);
    for (const Node& node : scene.nodes)
        for (const int child : node.children) hasParent[std::size_t(child)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        if (!hasParent[i]) roots.push_back(int(i));

    std::vector<Mat4d> worldFromNode(scene.nodes.size());
    for (const int root : roots)
        worldFromNode[std::size_t(root)] = parentFromNodeMatrix(parentFromNode[std::size_t(root)]);
    for (const int parent : nodesBelow(scene, roots))
        for (const int child : scene.nodes[std::size_t(parent)].children)
            worldFromNode[std::size_t(child)] =
                worldFromNode[std::size_t(parent)] * parentFromNodeMatrix(parentFromNode[std::size_t(child)]);
    return worldFromNode;
}

void play(const Animation& animation, double time, std::vector<NodeTransform>& transforms, Pose& pose)
{
    const double at = repeatedTime(animation, time);
    for (const AnimationChannel& channel : animation.channels) {
        NodeTransform& transform = transforms[std::size_t(channel.node)];
        if (channel.path == AnimationPath::MorphWeights) {
            std::vector<double>& weights = pose.morphWeights[std::size_t(channel.node)];
            weights.resize(valueSize(channel));
            sampleChannel(channel, at, weights);
            continue;
        }
        std::array<double, 4> v{};
        sampleChannel(channel, at, std::span(v).first(valueSize(channel)));
        if (channel.path == AnimationPath::Translation) transform.translation = {v[0], v[1], v[2]};
        if (channel.path == AnimationPath::Scale) transform.scale = {v[0], v[1], v[2]};
        if (channel.path == AnimationPath::Rotation) transform.rotation = {v[0], v[1], v[2], v[3]};
    }
}

Pose makePose(const Scene& scene, const Animation* animation, double time)
{
    Pose pose;
    std::vector<NodeTransform> transforms;
    for (const Node& node : scene.nodes) {
        transforms.push_back(node.parentFromNode);
        pose.morphWeights.emplace_back(node.morphWeights.begin(), node.morphWeights.end());
    }
    if (animation) play(*animation, time, transforms, pose);
    pose.worldFromNode = placeNodes(scene, transforms);
    return pose;
}

} // namespace

Pose restPose(const Scene& scene) { return makePose(scene, nullptr, 0); }

Pose poseAt(const Scene& scene, const EvaluateOptions& options)
{
    if (scene.animations.empty()) return restPose(scene);
    LX_ASSERT(options.animation >= 0 && std::size_t(options.animation) < scene.animations.size());
    return makePose(scene, &scene.animations[std::size_t(options.animation)], options.time);
}

std::vector<int> drawnNodes(const Scene& scene) { return nodesBelow(scene, scene.roots); }

} // namespace lixel
