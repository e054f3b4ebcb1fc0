// SPDX-License-Identifier: MIT
#include "lixel/report/scene_optimal_metrics.h"

#include <gtest/gtest.h>

namespace lixel {
namespace {

// Two lights and three techniques each. "right" orders the techniques as their errors do, "wrong" the other way round.
SceneOptimalMetrics twoLights()
{
    SceneOptimalMetrics study;
    study.metrics = {"right", "wrong"};
    study.techniques = {"a", "b", "c"};
    study.cases = {{"sun", "a", 100, 50, 0, {{"right", 2}, {"wrong", 1}}},
                   {"sun", "b", 200, 50, 0, {{"right", 4}, {"wrong", 0.5}}},
                   {"sun", "c", 300, 50, 0, {{"right", 6}, {"wrong", 0.2}}},
                   {"moon", "a", 300, 300, 0, {{"right", 1}, {"wrong", 9}}},
                   {"moon", "b", 150, 300, 0, {{"right", 0.5}, {"wrong", 10}}},
                   {"moon", "c", 600, 300, 0, {{"right", 3}, {"wrong", 8}}}};
    return study;
}

TEST(SceneOptimalMetrics, OfErrorsAsTheEnergyIsAreRankedAlike)
{
    const MetricRanks right = metricRanks(twoLights()).front();
    EXPECT_EQ(right.metric, "right");
    EXPECT_DOUBLE_EQ(right.withinLights, 1);
    EXPECT_EQ(right.lightsRanked, 2);
    EXPECT_EQ(right.bestFound, 2);
    EXPECT_DOUBLE_EQ(right.lossOfChoice, 1);
    EXPECT_DOUBLE_EQ(right.ofTechnique.at("a").value(), 1) << "2 and 1 errors for each sample of the boundary";
}

TEST(SceneOptimalMetrics, ThatMisleadCostWhatTheirChoiceErrsMore)
{
    const MetricRanks wrong = metricRanks(twoLights()).back();
    EXPECT_DOUBLE_EQ(wrong.withinLights, -1);
    EXPECT_EQ(wrong.bestFound, 0);
    EXPECT_DOUBLE_EQ(wrong.lossOfChoice, (300.0 + 600) / (100 + 150));
}

TEST(SceneOptimalMetrics, HaveNoOrderOverOneLight)
{
    SceneOptimalMetrics study = twoLights();
    study.cases.resize(3);
    EXPECT_FALSE(metricRanks(study).front().ofTechnique.at("a"));
}

} // namespace
} // namespace lixel
