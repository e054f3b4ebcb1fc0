// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin.h"

#include "lixel/scene/evaluate.h"
#include "lixel/scene/framing.h"
#include "lixel/scene/load.h"
#include "lixel/scene/view_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>

namespace lixel::test {
namespace {

std::shared_ptr<const Scene> built(const std::string& text)
{
    return std::make_shared<Scene>(buildBuiltin(text).value());
}

LocalTriangles trianglesOf(const std::shared_ptr<const Scene>& scene, double time = 0)
{
    EvaluateOptions options;
    options.time = time;
    return evaluate(scene, options, {0, 0, 0}).triangles;
}

std::size_t triangleCount(const std::string& text) { return trianglesOf(built(text)).triangleCount(); }

std::array<Vec3d, 3> corners(const LocalTriangles& all, std::size_t triangle)
{
    const auto p = [&](std::size_t k) { return toDouble(all.positionLocal[all.indices[3 * triangle + k]]); };
    return {p(0), p(1), p(2)};
}

std::string messageOf(const std::string& text)
{
    try {
        buildBuiltin(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

// Each property holds for every scene.
class EveryScene : public ::testing::TestWithParam<std::string>
{
protected:
    std::shared_ptr<const Scene> scene = built(GetParam());
    Box bounds = sceneBounds(*scene, {});
};

std::vector<std::string> names()
{
    std::vector<std::string> all;
    for (const BuiltinScene& scene : builtinScenes()) all.emplace_back(scene.name);
    return all;
}

INSTANTIATE_TEST_SUITE_P(Builtin, EveryScene, ::testing::ValuesIn(names()),
                         [](const auto& given) { return given.param; });

TEST_P(EveryScene, HasAtLeastEightViewsThatCanBeTaken)
{
    EXPECT_GE(scene->views.size(), 8u);
    std::set<std::string> viewNames;
    for (const NamedView& view : scene->views) {
        EXPECT_TRUE(viewNames.insert(view.name).second) << view.name << " is there twice";
        EXPECT_FALSE(view.description.empty()) << view.name;
        EXPECT_EQ(checkCamera(view.camera), std::nullopt) << view.name;
        EXPECT_TRUE(inverse(makeView(view.camera, 64, 48, bounds).clipFromAnchored)) << view.name;
        EXPECT_FALSE(view.lights.empty()) << view.name;
        std::set<std::string> lightNames;
        for (const Light& light : view.lights) {
            EXPECT_TRUE(lightNames.insert(light.name).second) << view.name << ": two lights " << light.name;
            EXPECT_EQ(checkLight(light), std::nullopt) << view.name << ": " << light.name;
            EXPECT_NEAR(length(light.directionWorld), 1, 1e-12) << view.name;
        }
    }
    for (const char* hard : {"overview", "light-in-front", "grazing", "light-at-eye"})
        EXPECT_TRUE(viewNames.count(hard)) << hard;
}

TEST_P(EveryScene, HasEveryKindOfLightAndAViewWithSeveral)
{
    std::set<LightKind> kinds;
    std::size_t most = 0;
    for (const NamedView& view : scene->views) {
        most = std::max(most, view.lights.size());
        for (const Light& light : view.lights) kinds.insert(light.kind);
    }
    EXPECT_GE(most, 2u);
    EXPECT_TRUE(kinds.count(LightKind::Spot) && kinds.count(LightKind::Point));
    EXPECT_TRUE(kinds.count(LightKind::Directional) || GetParam() == "lamp");
}

TEST_P(EveryScene, HasAPathOfCameraAndLight)
{
    ASSERT_GE(scene->path.size(), 4u);
    bool lightMoves = false;
    for (std::size_t i = 0; i < scene->path.size(); ++i) {
        const PathKey& key = scene->path[i];
        EXPECT_EQ(checkCamera(cameraAt(scene->path, key.time, Camera())), std::nullopt);
        EXPECT_TRUE(key.lightPositionWorld || key.lightDirectionWorld);
        if (i == 0) continue;
        EXPECT_GT(key.time, scene->path[i - 1].time);
        const double middle = 0.5 * (key.time + scene->path[i - 1].time);
        EXPECT_EQ(checkCamera(cameraAt(scene->path, middle, Camera())), std::nullopt);
        lightMoves |= key.lightPositionWorld != scene->path[0].lightPositionWorld ||
                      key.lightDirectionWorld != scene->path[0].lightDirectionWorld;
    }
    EXPECT_TRUE(lightMoves);
}

TEST_P(EveryScene, NamesPlanesThatReceiversLieIn)
{
    EXPECT_FALSE(scene->planes.empty());
    const LocalTriangles all = trianglesOf(scene);
    for (const NamedPlane& plane : scene->planes) {
        EXPECT_NEAR(length(plane.normalWorld), 1, 1e-12);
        const Plane through = planeThrough(plane.pointWorld, plane.normalWorld);
        bool holdsOne = false;
        for (std::size_t t = 0; t < all.triangleCount() && !holdsOne; ++t) {
            const auto c = corners(all, t);
            holdsOne = std::ranges::all_of(c, [&](Vec3d p) { return std::abs(through.signedDistance(p)) < 2e-3; });
        }
        EXPECT_TRUE(holdsOne) << plane.name;
    }
}

TEST_P(EveryScene, IsTheSameEveryTime)
{
    const LocalTriangles once = trianglesOf(scene), again = trianglesOf(built(GetParam()));
    EXPECT_EQ(once.positionLocal, again.positionLocal);
    EXPECT_EQ(once.indices, again.indices);
    EXPECT_EQ(once.uv, again.uv);
    EXPECT_EQ(once.normal, again.normal);
    EXPECT_EQ(once.material, again.material);
}

TEST_P(EveryScene, HasNoTriangleWithoutAreaAndNoVertexThatIsNotFinite)
{
    const LocalTriangles all = trianglesOf(scene);
    std::size_t flat = 0;
    for (std::size_t t = 0; t < all.triangleCount(); ++t) {
        const auto c = corners(all, t);
        const Vec3d areaNormal = cross(c[1] - c[0], c[2] - c[0]);
        flat += !(length(areaNormal) > 0);
    }
    EXPECT_EQ(flat, 0u);
    EXPECT_TRUE(std::ranges::all_of(all.positionLocal, [](Vec3f p) { return isFinite(toDouble(p)); }));
    EXPECT_TRUE(std::ranges::all_of(all.normal, [](Vec3f n) { return std::abs(length(toDouble(n)) - 1) < 1e-4; }));
    for (const std::uint32_t index : all.indices) ASSERT_LT(index, all.positionLocal.size());
    for (const std::uint32_t material : all.material) ASSERT_LT(material, scene->materials.size());
}

// Where two surfaces share a place, which of them is seen would be chance. Triangles are sorted by their planes; those
// in one plane, shrunk by a thousandth, must not overlap.
struct Flat
{
    std::size_t triangle;
    std::array<Vec2d, 3> corner;
    double low, high; // in x
};

bool overlap(const Flat& a, const Flat& b)
{
    for (const Flat* first : {&a, &b})
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2d edge = first->corner[(i + 1) % 3] - first->corner[i];
            const auto range = [&](const Flat& f) {
                const auto side = [&](std::size_t k) { return cross(edge, f.corner[k]); };
                return std::pair{std::min({side(0), side(1), side(2)}), std::max({side(0), side(1), side(2)})};
            };
            const auto [lowA, highA] = range(a);
            const auto [lowB, highB] = range(b);
            if (highA <= lowB || highB <= lowA) return false;
        }
    return true;
}

Flat flattened(std::size_t triangle, const std::array<Vec3d, 3>& c, Vec3d normal)
{
    const Vec3d u = anyPerpendicular(normal), v = cross(normal, u);
    const Vec3d middle = (c[0] + c[1] + c[2]) / 3;
    Flat flat{triangle, {}, 1e300, -1e300};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d p = middle + 0.999 * (c[k] - middle);
        flat.corner[k] = {dot(p, u), dot(p, v)};
        flat.low = std::min(flat.low, flat.corner[k].x);
        flat.high = std::max(flat.high, flat.corner[k].x);
    }
    return flat;
}

// To what floats can tell, where the scene is.
bool inOnePlane(const std::array<Vec3d, 3>& a, const std::array<Vec3d, 3>& b)
{
    const Plane plane = planeThrough(a[0], normalized(cross(a[1] - a[0], a[2] - a[0])));
    return std::ranges::all_of(b, [&](Vec3d p) { return std::abs(plane.signedDistance(p)) < 1e-6 + 2e-7 * length(p); });
}

TEST_P(EveryScene, HasNoTwoSurfacesInOnePlace)
{
    const LocalTriangles all = trianglesOf(scene);
    std::map<std::array<long, 4>, std::vector<Flat>> planes;
    for (std::size_t t = 0; t < all.triangleCount(); ++t) {
        const auto c = corners(all, t);
        Vec3d normal = normalized(cross(c[1] - c[0], c[2] - c[0]));
        const double sign = std::abs(normal.x) > 1e-4 ? normal.x : std::abs(normal.y) > 1e-4 ? normal.y : normal.z;
        if (sign < 0) normal = -normal;
        const Vec3d cell{1e-4 * std::round(normal.x * 1e4), 1e-4 * std::round(normal.y * 1e4),
                         1e-4 * std::round(normal.z * 1e4)};
        const auto rounded = [](double x) { return std::lround(x * 1e4); };
        planes[{rounded(cell.x), rounded(cell.y), rounded(cell.z), std::lround(dot(cell, c[0]) * 2e4)}].push_back(
            flattened(t, c, normalized(cell)));
    }
    int doubled = 0;
    for (auto& [plane, flats] : planes) {
        std::ranges::sort(flats, {}, &Flat::low);
        for (std::size_t i = 0; i < flats.size(); ++i)
            for (std::size_t j = i + 1; j < flats.size() && flats[j].low < flats[i].high; ++j) {
                const auto a = corners(all, flats[i].triangle), b = corners(all, flats[j].triangle);
                if (!overlap(flats[i], flats[j]) || !inOnePlane(a, b) || doubled++ >= 3) continue;
                ADD_FAILURE() << "triangles at " << a[0].x << ' ' << a[0].y << ' ' << a[0].z << " and " << b[0].x << ' '
                              << b[0].y << ' ' << b[0].z;
            }
    }
    EXPECT_EQ(doubled, 0);
}

struct Hit
{
    double distance = std::numeric_limits<double>::infinity();
    Vec3d point, normalToEye;
    bool isFront = false;
};

// The nearest triangle along a ray (Möller and Trumbore 1997), over all triangles.
Hit nearestHit(const LocalTriangles& all, Vec3d from, Vec3d along)
{
    Hit hit;
    for (std::size_t t = 0; t < all.triangleCount(); ++t) {
        const auto c = corners(all, t);
        const Vec3d e1 = c[1] - c[0], e2 = c[2] - c[0], p = cross(along, e2);
        const double determinant = dot(e1, p);
        if (determinant == 0) continue;
        const Vec3d s = from - c[0], q = cross(s, e1);
        const double u = dot(s, p) / determinant, v = dot(along, q) / determinant, distance = dot(e2, q) / determinant;
        if (!(u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && distance < hit.distance)) continue;
        const Vec3d normal = normalized(cross(e1, e2));
        hit = {distance, from + distance * along, determinant > 0 ? normal : -normal, determinant > 0};
    }
    return hit;
}

// A view from inside a solid would see back sides only.
TEST_P(EveryScene, ViewsSeeLitFrontsOfThings)
{
    constexpr int kColumns = 4, kRows = 3;
    const LocalTriangles all = trianglesOf(scene);
    for (const NamedView& named : scene->views) {
        const View view = makeView(named.camera, kColumns, kRows, bounds);
        const Mat4d anchoredFromClip = inverse(view.clipFromAnchored).value();
        int hits = 0, fronts = 0, facing = 0;
        for (int i = 0; i < kColumns * kRows; ++i) {
            const double x = (i % kColumns + 0.5) / kColumns, y = (i / kColumns + 0.5) / kRows;
            const Vec3d along = normalized(project(anchoredFromClip, {2 * x - 1, 2 * y - 1, 0}));
            const Hit hit = nearestHit(all, view.anchorWorld, along);
            if (!std::isfinite(hit.distance)) continue;
            ++hits;
            fronts += hit.isFront;
            facing += std::ranges::any_of(
                named.lights, [&](const Light& light) { return isLightFacing(light, {}, hit.point, hit.normalToEye); });
        }
        EXPECT_GE(hits, kColumns * kRows / 2) << named.name;
        EXPECT_GE(fronts, hits - 3) << named.name;
        EXPECT_GE(facing, hits / 4) << named.name;
    }
}

TEST_P(EveryScene, GrowsWithItsFirstParameter)
{
    const BuiltinScene& entry = *std::ranges::find(builtinScenes(), GetParam(), &BuiltinScene::name);
    ASSERT_FALSE(entry.parameters.empty());
    const BuiltinParameter& p = entry.parameters[0];
    EXPECT_TRUE(p.least <= p.standard && p.standard <= p.most);
    const auto with = [&](double value) {
        return triangleCount(GetParam() + "(" + std::string(p.name) + "=" + std::to_string(int(value)) + ")");
    };
    EXPECT_LT(with(p.least), with(p.standard));
    EXPECT_LT(with(p.standard), with(1.5 * p.standard));
    EXPECT_NE(messageOf(GetParam() + ":" + std::string(p.name) + "=" + std::to_string(int(p.most) + 1))
                  .find("expected a whole number from"),
              std::string::npos);
}

TEST(Builtin, TheEightScenesAreThere)
{
    EXPECT_EQ(names(),
              (std::vector<std::string>{"bunnies", "table", "objects", "colonnade", "fence", "city", "lamp", "balls"}));
}

TEST(Builtin, TriangleCountsAreAsPromised)
{
    EXPECT_LT(triangleCount("bunnies"), 100000u);
    EXPECT_NEAR(double(triangleCount("objects")), 1137772, 0.05 * 1137772);
    for (const int asked : {1000, 3000, 10'000, 1'000'000})
        EXPECT_NEAR(double(triangleCount("balls:" + std::to_string(asked))), asked, 0.16 * asked);
    const Box city = sceneBounds(*built("city"), {});
    EXPECT_GT(city.max.x - city.min.x, 1000);
}

TEST(Builtin, AMaskedMaterialIsAmongTheFences)
{
    const auto scene = built("fence");
    EXPECT_TRUE(std::ranges::any_of(
        scene->materials, [](const Material& m) { return m.alphaMode == AlphaMode::Mask && m.texture >= 0; }));
}

TEST(Builtin, BunniesJumpAndComeBack)
{
    const auto scene = built("bunnies");
    const LocalTriangles start = trianglesOf(scene, 0), later = trianglesOf(scene, 0.4), round = trianglesOf(scene, 4);
    double moved = 0, apart = 0;
    for (std::size_t i = 0; i < start.positionLocal.size(); ++i) {
        moved = std::max(moved, length(toDouble(start.positionLocal[i]) - toDouble(later.positionLocal[i])));
        apart = std::max(apart, length(toDouble(start.positionLocal[i]) - toDouble(round.positionLocal[i])));
    }
    EXPECT_GT(moved, 0.3);
    EXPECT_LT(apart, 1e-5);
}

TEST(Builtin, BunniesLandOnTheFloorAndNotBelow)
{
    const auto scene = built("bunnies");
    double lowest = 1;
    for (double time = 0; time < 4; time += 0.05)
        for (std::size_t i = 0; i < scene->nodes.size(); ++i) {
            Scene moved = *scene;
            moved.animate(moved, time);
            if (scene->nodes[i].name.starts_with("bunny"))
                lowest = std::min(lowest, moved.nodes[i].parentFromNode.translation.y);
        }
    EXPECT_LT(lowest, 0.1);
    EXPECT_GE(lowest, -0.0011);
}

// A light outside the box of all geometry has it within a hemisphere, so that one map can serve it.
TEST(Builtin, LampsOfBunniesStandOutsideTheScene)
{
    const auto scene = built("bunnies");
    EvaluateOptions options;
    for (options.time = 0; options.time < 4; options.time += 0.25) {
        const Box bounds = sceneBounds(*scene, options);
        for (const NamedView& view : scene->views)
            for (const Light& light : view.lights) {
                if (light.kind == LightKind::Directional) continue;
                const Vec3d p = light.positionWorld;
                const bool isInside = p.x > bounds.min.x && p.x < bounds.max.x && p.y > bounds.min.y &&
                                      p.y < bounds.max.y && p.z > bounds.min.z && p.z < bounds.max.z;
                EXPECT_FALSE(isInside) << view.name << " at " << options.time;
            }
    }
}

TEST(BuiltinText, NamesTakeParametersInEveryWriting)
{
    const std::size_t twelve = triangleCount("bunnies(count=12)");
    EXPECT_GT(twelve, triangleCount("bunnies"));
    for (const char* text : {"bunnies(12)", "bunnies:12", "bunnies:count=12"})
        EXPECT_EQ(triangleCount(text), twelve) << text;
    EXPECT_EQ(triangleCount("bunnies()"), triangleCount("bunnies"));
    EXPECT_EQ(triangleCount("fence(sections=2,tufts=3)"), triangleCount("fence(3,2)"));
}

TEST(BuiltinText, OtherWordsAreNoBuiltins)
{
    for (const char* text : {"", "bunny", "bunnies.glb", "./bunnies", "Bunnies", "(count=1)", "some/city(3)"})
        EXPECT_FALSE(buildBuiltin(text)) << text;
}

TEST(BuiltinText, MistakesAreNamed)
{
    const struct
    {
        std::string text, expected;
    } cases[] = {
        {"bunnies(count=12", "closing parenthesis"},
        {"bunnies(count=12)x", "closing parenthesis"},
        {"bunnies(count=0)", "bunnies: count=0: expected a whole number from 1 to 1000"},
        {"bunnies(count=1000000000)", "expected a whole number from 1 to 1000"},
        {"bunnies(count=99999999999999999999)", "expected a whole number from 1 to 1000"},
        {"bunnies(count=2.5)", "expected a whole number"},
        {"bunnies(count=nan)", "expected a whole number"},
        {"bunnies(count=)", "expected a whole number"},
        {"bunnies(count= 3)", "expected a whole number"},
        {"bunnies(size=3)", "\"size=3\" is not one of its parameters: count=3 (1 to 1000)"},
        {"bunnies(3,4)", "\"4\" is not one of its parameters"},
        {"bunnies(count=3,count=4)", "count is given twice"},
        {"bunnies(3,count=4)", "count is given twice"},
        {"bunnies(,)", "expected a whole number"},
    };
    for (const auto& c : cases)
        EXPECT_NE(messageOf(c.text).find(c.expected), std::string::npos) << c.text << ": " << messageOf(c.text);
}

} // namespace
} // namespace lixel::test
