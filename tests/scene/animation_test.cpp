// SPDX-License-Identifier: MIT
#include "lixel/scene/animation.h"

#include <gtest/gtest.h>

#include "scene/loaded.h"
#include "support/random_cases.h"

namespace lixel::test {
namespace {

AnimationChannel anyChannel(AnimationPath path, Interpolation interpolation, Rng& rng)
{
    AnimationChannel channel;
    channel.path = path, channel.interpolation = interpolation;
    const std::size_t size = path == AnimationPath::Rotation ? 4 : 3;
    const int keys = rng.integer(1, 6);
    float time = float(rng.uniform(-1, 1));
    for (int k = 0; k < keys; ++k) {
        channel.time.push_back(time);
        time += float(rng.uniform(0.1, 2));
        const std::size_t numbers = size * (interpolation == Interpolation::CubicSpline ? 3 : 1);
        for (std::size_t i = 0; i < numbers; ++i) channel.value.push_back(float(rng.uniform(-2, 2)));
    }
    return channel;
}

std::vector<double> sampled(const AnimationChannel& channel, double time)
{
    std::vector<double> value(valueSize(channel));
    sampleChannel(channel, time, value);
    return value;
}

TEST(Animation, AtAKeyTheValueIsTheKeysWhateverTheInterpolation)
{
    forEachCase(kCases, [](Rng& rng) {
        const auto interpolation = Interpolation(rng.integer(0, 2));
        const AnimationChannel channel = anyChannel(AnimationPath::Translation, interpolation, rng);
        const std::size_t parts = interpolation == Interpolation::CubicSpline ? 3 : 1;
        for (std::size_t k = 0; k < channel.time.size(); ++k) {
            const std::vector<double> value = sampled(channel, double(channel.time[k]));
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_EQ(value[i], double(channel.value[(k * parts + parts / 2) * 3 + i]));
        }
    });
}

TEST(Animation, OutsideItsKeysAChannelRests)
{
    forEachCase(kCases, [](Rng& rng) {
        const AnimationChannel channel = anyChannel(AnimationPath::Scale, Interpolation(rng.integer(0, 2)), rng);
        EXPECT_EQ(sampled(channel, double(channel.time.front()) - 5), sampled(channel, double(channel.time.front())));
        EXPECT_EQ(sampled(channel, double(channel.time.back()) + 5), sampled(channel, double(channel.time.back())));
    });
}

TEST(Animation, RotationsAreUnitAndContinuousAtTheirKeys)
{
    forEachCase(kCases, [](Rng& rng) {
        const AnimationChannel channel = anyChannel(AnimationPath::Rotation, Interpolation::Linear, rng);
        const std::vector<double> q = sampled(channel, rng.uniform(-1, 12));
        EXPECT_NEAR(std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])), 1, 1e-12);
        for (const float key : channel.time) {
            const std::vector<double> before = sampled(channel, double(key) - 1e-9), at = sampled(channel, double(key));
            double cosine = 0;
            for (std::size_t i = 0; i < 4; ++i) cosine += before[i] * at[i];
            EXPECT_NEAR(std::abs(cosine), 1, 1e-9); // q and -q are one rotation
        }
    });
}

// A cubic through the samples of a cubic, with its derivatives as tangents, is that cubic.
TEST(Animation, ASplineReproducesCubics)
{
    forEachCase(kCases, [](Rng& rng) {
        const double a = rng.uniform(-1, 1), b = rng.uniform(-1, 1), c = rng.uniform(-1, 1), d = rng.uniform(-1, 1);
        const auto cubic = [&](double t) { return ((a * t + b) * t + c) * t + d; };
        const auto slope = [&](double t) { return (3 * a * t + 2 * b) * t + c; };
        AnimationChannel channel;
        channel.path = AnimationPath::MorphWeights, channel.interpolation = Interpolation::CubicSpline;
        for (const float t : {0.0f, 0.5f, 2.0f}) {
            channel.time.push_back(t);
            const float tangent = float(slope(double(t)));
            channel.value.insert(channel.value.end(), {tangent, float(cubic(double(t))), tangent});
        }
        const double t = rng.uniform(0, 2);
        EXPECT_NEAR(sampled(channel, t)[0], cubic(t), 1e-5);
    });
}

TEST(Animation, BeyondItsEndItRepeats)
{
    Animation animation;
    animation.channels.resize(2);
    animation.channels[0].time = {0, 1.5f};
    animation.channels[1].time = {0.5f, 2};
    EXPECT_EQ(repeatedTime(animation, 1.25), 1.25);
    EXPECT_EQ(repeatedTime(animation, 2), 2); // the end itself is the end
    EXPECT_EQ(repeatedTime(animation, 2.25), 0.25);
    EXPECT_EQ(repeatedTime(animation, 200.5), 0.5);
    EXPECT_EQ(repeatedTime(animation, -0.5), 1.5);
    EXPECT_EQ(repeatedTime(Animation{}, 7), 0);
}

std::vector<Vec3f> cornersOfNode(const SceneBuffers& buffers, std::size_t node)
{
    const std::vector<Vec3f> all = corners(buffers);
    return {all.begin() + std::ptrdiff_t(3 * node), all.begin() + std::ptrdiff_t(3 * node + 3)};
}

TEST(Animation, NodesMoveTurnAndGrowAsTheFileSays)
{
    const auto scene = loadData("node_animation.gltf");
    const double h = std::sqrt(0.5);
    const auto turned = [](double cosine, double sine) {
        return std::vector<Vec3f>{{0, 0, 0}, toFloat(Vec3d{cosine, sine, 0}), toFloat(Vec3d{-sine, cosine, 0})};
    };
    const SceneBuffers early = evaluate(scene, {0.5, 0}, {});
    expectNear(cornersOfNode(early, 0), {{0.5f, 1, 1.5f}, {1.5f, 1, 1.5f}, {0.5f, 2, 1.5f}}, 1e-6);
    expectNear(cornersOfNode(early, 1), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 0);
    expectNear(cornersOfNode(early, 2), turned(h, h), 1e-6);
    expectNear(cornersOfNode(early, 3), {{0, 0, 0}, {1.5f, 0, 0}, {0, 1.5f, 0}}, 1e-6);

    const SceneBuffers late = evaluate(scene, {2, 0}, {});
    expectNear(cornersOfNode(late, 0), {{3, 2, 3}, {4, 2, 3}, {3, 3, 3}}, 1e-6);
    expectNear(cornersOfNode(late, 1), {{1, 2, 3}, {2, 2, 3}, {1, 3, 3}}, 1e-6);
    expectNear(cornersOfNode(late, 2), turned(-h, h), 1e-6); // from 90 to 180 degrees the shorter way
    expectNear(cornersOfNode(late, 3), {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, 1e-6);
}

TEST(Animation, AnotherAnimationOfTheFileMovesOnlyItsOwn)
{
    const auto scene = loadData("node_animation.gltf");
    const SceneBuffers one = evaluate(scene, {2, 1}, {});
    expectNear(cornersOfNode(one, 0), {{3, 2, 3}, {4, 2, 3}, {3, 3, 3}}, 1e-6);
    for (std::size_t node = 1; node < 4; ++node)
        expectNear(cornersOfNode(one, node), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 0);
}

TEST(Animation, ARoundLaterEverythingIsTheSame)
{
    const auto scene = loadData("node_animation.gltf"); // three seconds long
    for (const double time : {0.25, 1.0, 2.5}) {
        const SceneBuffers first = evaluate(scene, {time, 0}, {}), later = evaluate(scene, {time + 3 * 8, 0}, {});
        EXPECT_EQ(first.triangles.positionLocal, later.triangles.positionLocal);
        EXPECT_EQ(first.version, later.version);
    }
}

} // namespace
} // namespace lixel::test
