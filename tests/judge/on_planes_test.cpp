// SPDX-License-Identifier: MIT
#include "lixel/judge/on_planes.h"

#include <gtest/gtest.h>

#include <array>

namespace lixel {
namespace {

ViewSamples samplesAt(std::initializer_list<Vec3f> positions, Vec3f normal, Vec3d originWorld)
{
    ViewSamples samples;
    samples.originWorld = originWorld;
    for (const Vec3f& p : positions) {
        samples.pixel.push_back({});
        samples.positionLocal.push_back(p);
        samples.normal.push_back(normal);
        samples.triangle.push_back(kNoTriangle);
    }
    return samples;
}

TEST(OnPlanes, ASampleIsOnThePlaneThatItsFloatsCannotTellItFrom)
{
    const Vec3d origin{1000, 200, -300};
    const std::array<NamedPlane, 2> planes{
        NamedPlane{"table",
                   {1000, 201, -300},
                   {0, 1, 0},
                   {{999, 201, -301}, {999, 201, -299}, {1001, 201, -299}, {1001, 201, -301}}},
        NamedPlane{"floor", {0, 200, 0}, {0, -1, 0}, {}}};
    const ViewSamples samples =
        samplesAt({{0, 1, 0.5f}, {0, 1, 1.5f}, {7, 0, 9}, {7, 1e-6f, 9}, {7, 1e-3f, 9}}, {0, 1, 0}, origin);
    EXPECT_EQ(planeOfSamples(samples, planes), (std::vector<int>{0, kOnNoPlane, 1, 1, kOnNoPlane}));
    EXPECT_EQ(planeOfSamples(samplesAt({{7, 0, 9}}, {0, 0.99f, 0.141f}, origin), planes),
              (std::vector<int>{kOnNoPlane}));
}

TEST(PlaneErrors, AnEdgeBesideExplainsEitherErrorAndACasterNearByOnlyALostShadow)
{
    const std::array<float, 4> dark{0, 0, 0, 0}, lit{1, 1, 1, 1}, edge{0, 0, 1, 0};
    EXPECT_EQ(causeOfPlaneError(0, edge, false), PlaneErrorCause::NearEdge);
    EXPECT_EQ(causeOfPlaneError(1, edge, false), PlaneErrorCause::NearEdge);
    EXPECT_EQ(causeOfPlaneError(0, dark, true), PlaneErrorCause::NearCaster);
    EXPECT_EQ(causeOfPlaneError(0, dark, false), PlaneErrorCause::Unexplained);
    EXPECT_EQ(causeOfPlaneError(1, lit, true), PlaneErrorCause::Unexplained);
    PlaneErrorCauses count;
    for (const PlaneErrorCause cause : {PlaneErrorCause::NearEdge, PlaneErrorCause::NearEdge,
                                        PlaneErrorCause::NearCaster, PlaneErrorCause::Unexplained})
        count.add(cause);
    EXPECT_EQ(count.nearEdge, 2);
    EXPECT_EQ(count.nearCaster, 1);
    EXPECT_EQ(count.unexplained, 1);
}

} // namespace
} // namespace lixel
