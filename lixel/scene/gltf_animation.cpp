// SPDX-License-Identifier: MIT
#include "lixel/scene/gltf_animation.h"

#include "lixel/scene/gltf_accessor.h"
#include "lixel/scene/input_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace lixel::gltf {
namespace {

std::optional<AnimationPath> readPath(const JsonAt& path)
{
    if (path.text() == "translation") return AnimationPath::Translation;
    if (path.text() == "rotation") return AnimationPath::Rotation;
    if (path.text() == "scale") return AnimationPath::Scale;
    if (path.text() == "weights") return AnimationPath::MorphWeights;
    return std::nullopt;
}

Interpolation readInterpolation(const JsonAt& sampler)
{
    const auto interpolation = sampler.find("interpolation");
    if (!interpolation || interpolation->text() == "LINEAR") return Interpolation::Linear;
    if (interpolation->text() == "STEP") return Interpolation::Step;
    if (interpolation->text() == "CUBICSPLINE") return Interpolation::CubicSpline;
    interpolation->refuse(
        fmt::format("expected LINEAR, STEP or CUBICSPLINE, found '{}'", printable(interpolation->text())));
}

std::vector<float> readTimes(File& file, const JsonAt& reference)
{
    std::vector<float> times = Accessor(file, reference).expect(1).floats();
    if (!std::is_sorted(times.begin(), times.end())) reference.refuse("expected times in ascending order");
    return times;
}

// Numbers of one key, times three for cubic splines (section 3.11, appendix C).
std::size_t floatsPerKey(AnimationPath path, const Node& node, const Scene& scene)
{
    if (path == AnimationPath::Rotation) return 4;
    if (path != AnimationPath::MorphWeights) return 3;
    return node.meshes.empty() ? 0 : scene.meshes[std::size_t(node.meshes.front())].morphTargets.size();
}

std::optional<AnimationChannel> readChannel(File& file, const JsonAt& source, const JsonAt& samplers,
                                            const Scene& scene)
{
    const JsonAt target = source.require("target");
    AnimationChannel channel;
    channel.node = target.indexOr("node", scene.nodes.size(), "nodes");
    const auto path = readPath(target.require("path"));
    if (channel.node < 0 || !path) {
        file.warnings.push_back(
            fmt::format("{}: {}: a target that is not known is left out", file.name(), target.place()));
        return std::nullopt;
    }
    channel.path = *path;
    const Node& node = scene.nodes[std::size_t(channel.node)];
    if (node.parentFromNode.matrix && channel.path != AnimationPath::MorphWeights)
        target.refuse(fmt::format("expected nodes[{}] to have no 'matrix', since it is animated", channel.node));

    const JsonAt sampler = samplers[std::size_t(source.require("sampler").index(samplers.size(), "samplers"))];
    channel.interpolation = readInterpolation(sampler);
    channel.time = readTimes(file, sampler.require("input"));
    const JsonAt output = sampler.require("output");
    channel.value = Accessor(file, output).floats();
    const std::size_t perKey = floatsPerKey(channel.path, node, scene);
    if (perKey == 0) return std::nullopt; // weights of a mesh without targets
    const std::size_t expected =
        channel.time.size() * perKey * (channel.interpolation == Interpolation::CubicSpline ? 3 : 1);
    if (channel.value.size() != expected)
        output.refuse(fmt::format("expected {} numbers for {} keys, found {}", expected, channel.time.size(),
                                  channel.value.size()));
    return channel;
}

} // namespace

void readAnimations(File& file, Scene& scene)
{
    for (std::size_t a = 0; a < file.count("animations"); ++a) {
        const JsonAt source = file.element("animations", int(a));
        Animation animation;
        animation.name = source.textOr("name", fmt::format("animation {}", a));
        const JsonAt channels = source.require("channels"), samplers = source.require("samplers");
        for (std::size_t c = 0; c < channels.size(); ++c)
            if (auto channel = readChannel(file, channels[c], samplers, scene))
                animation.channels.push_back(*std::move(channel));
        scene.animations.push_back(std::move(animation));
    }
}

} // namespace lixel::gltf
