// SPDX-License-Identifier: MIT
#include "lixel/plan/partition/find_planes.h"

#include "plan/random_setups.h"
#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

namespace lixel::test {
namespace {

// Surfaces as a picture shows them: samples where rays through random pixels first meet one, of a camera at the origin. Sizes
// are in units of `scale`, and positions and normals are floats relative to `originLocal`.
class Scenery
{
public:
    struct Hit
    {
        double distance;
        Vec3d normal;
    };
    using Surface = std::function<std::optional<Hit>(Vec3d ray)>;

    explicit Scenery(Rng& rng) : rng_(rng), scale_(rng.logUniform(1e-2, 1e3))
    {
        forward_ = rng.onSphere();
        right_ = anyPerpendicular(forward_);
        up_ = cross(right_, forward_);
        eye_ = rng.chance(0.5) ? Vec3d{} : scale_ * rng.inBox(5);
        view_ = perspectiveView(eye_, eye_ + forward_, up_, kFovy, 1e-3 * scale_, INFINITY, 1024, 1024);
    }

    // In the camera's own frame: x to the right, y up, z towards the viewer.
    Vec3d toLocal(Vec3d d) const { return d.x * right_ + d.y * up_ - d.z * forward_; }
    Plane toLocal(const Plane& p) const
    {
        return planeThrough(eye_ - scale_ * p.offset * toLocal(p.normal), toLocal(p.normal));
    }
    double scale() const { return scale_; }
    const View& view() const { return view_; }

    void add(Surface surface) { surfaces_.push_back(std::move(surface)); }
    void addPlane(
        const Plane& plane, std::function<bool(Vec3d)> holds = [](Vec3d) { return true; })
    {
        add([=](Vec3d ray) -> std::optional<Hit> {
            const double t = -plane.offset / dot(plane.normal, ray);
            if (!(t > 0) || !(t < 1e3) || !holds(t * ray)) return std::nullopt;
            return Hit{t, plane.normal};
        });
    }
    void addSphere(Vec3d centre, double radius)
    {
        add([=](Vec3d ray) -> std::optional<Hit> {
            const double b = dot(ray, centre), d = b * b - dot(ray, ray) * (dot(centre, centre) - radius * radius);
            if (!(d > 0) || b < 0) return std::nullopt;
            const double t = (b - std::sqrt(d)) / dot(ray, ray);
            return Hit{t, normalized(t * ray - centre)};
        });
    }

    // Angles of noise in the normals, and heights of noise along rays in pixels.
    double normalNoise = 0, roughness = 0;

    void look(int count)
    {
        const double half = std::tan(0.5 * kFovy);
        for (int i = 0; i < count; ++i) {
            const Vec3d ray{half * rng_.uniform(-1, 1), half * rng_.uniform(-1, 1), -1};
            std::optional<Hit> nearest;
            for (const Surface& surface : surfaces_)
                if (const auto hit = surface(ray); hit && (!nearest || hit->distance < nearest->distance))
                    nearest = hit;
            if (!nearest) continue;
            Vec3d p = nearest->distance * ray, n = nearest->normal;
            if (dot(n, ray) > 0) n = -n;
            const double pixel = 2 * half / 1024 * nearest->distance;
            p = p + roughness * pixel * rng_.uniform(-1, 1) * n;
            n = normalized(n + normalNoise * rng_.inBox(1));
            points.push_back(toDouble(toFloat(eye_ + scale_ * toLocal(p))));
            normals.push_back(toDouble(toFloat(toLocal(n))));
        }
    }

    PlaneSearch search() const { return {points, normals, weights, pixelSizeLocal(view_, {}), earlier}; }
    FoundPlanes found() const
    {
        FoundPlanes planes;
        PlaneScratch scratch;
        findPlanes(search(), scratch, planes);
        return planes;
    }

    std::vector<Vec3d> points, normals;
    std::vector<float> weights;
    std::vector<Plane> earlier;

    static constexpr double kFovy = 1;

private:
    Rng& rng_;
    double scale_;
    Vec3d forward_, right_, up_, eye_;
    View view_;
    std::vector<Surface> surfaces_;
};

// A floor below the camera and a wall before it, as far as they are seen.
struct Room
{
    Plane floor, wall;
};
Room addRoom(Scenery& scenery, Rng& rng)
{
    const double tilt = rng.uniform(-0.15, 0.15);
    const Room room{{{std::sin(tilt), std::cos(tilt), 0}, rng.uniform(0.5, 2)},
                    {normalized({rng.uniform(-0.5, 0.5), 0, 1}), rng.uniform(4, 12)}};
    scenery.addPlane(room.floor);
    scenery.addPlane(room.wall);
    return {scenery.toLocal(room.floor), scenery.toLocal(room.wall)};
}

void addClutter(Scenery& scenery, Rng& rng)
{
    for (int i = rng.integer(0, 12); i > 0; --i)
        scenery.addSphere({rng.uniform(-2, 2), rng.uniform(-1, 1), rng.uniform(-6, -3)}, rng.uniform(0.1, 0.4));
}

double pixelAt(const PlaneSearch& search, Vec3d p) { return dot(search.pixelSize, point(p)); }

const FoundPlane* closest(const FoundPlanes& planes, const Plane& plane)
{
    const FoundPlane* best = nullptr;
    for (const FoundPlane& f : planes)
        if (!best || dot(f.planeLocal.normal, plane.normal) > dot(best->planeLocal.normal, plane.normal)) best = &f;
    return best;
}

// Angle, and distance at the camera against the room's size: floats of positions can tell no more.
void expectSamePlane(const FoundPlane* found, const Plane& plane, const Scenery& scenery, double tolerance)
{
    ASSERT_TRUE(found);
    const Vec3d eye = scenery.view().anchorWorld;
    EXPECT_NEAR(length(cross(found->planeLocal.normal, plane.normal)), 0, tolerance);
    EXPECT_GT(dot(found->planeLocal.normal, plane.normal), 0);
    EXPECT_NEAR(found->planeLocal.signedDistance(eye), plane.signedDistance(eye), tolerance * 10 * scenery.scale());
    EXPECT_NEAR(length(found->planeLocal.normal), 1, 1e-12);
}

TEST(FindPlanes, FloorAndWallAmongClutterAreFoundExactly)
{
    forEachCase(kCases, [](Rng& rng) {
        Scenery scenery(rng);
        const Room room = addRoom(scenery, rng);
        addClutter(scenery, rng);
        scenery.look(4000);
        const FoundPlanes planes = scenery.found();
        EXPECT_EQ(planes.size(), 2u);
        expectSamePlane(closest(planes, room.floor), room.floor, scenery, 1e-6);
        expectSamePlane(closest(planes, room.wall), room.wall, scenery, 1e-6);
    });
}

TEST(FindPlanes, NormalsMayBeNoisyAndPositionsALittleRough)
{
    forEachCase(kCases, [](Rng& rng) {
        Scenery scenery(rng);
        scenery.normalNoise = rng.uniform(0, 0.02);
        scenery.roughness = rng.uniform(0, 0.5) * kFlatWithinPixels;
        const Room room = addRoom(scenery, rng);
        addClutter(scenery, rng);
        scenery.look(4000);
        const FoundPlanes planes = scenery.found();
        EXPECT_EQ(planes.size(), 2u);
        // The mean of many errors: at the ends of the samples, a quarter of what one may be off.
        for (const Plane& plane : {room.floor, room.wall}) {
            const FoundPlane* f = closest(planes, plane);
            ASSERT_TRUE(f);
            for (const Vec3d& corner : f->cornersLocal)
                EXPECT_NEAR(plane.signedDistance(corner), 0, kFlatWithinPixels / 4 * pixelAt(scenery.search(), corner));
        }
    });
}

TEST(FindPlanes, SharesArePartsOfAllWeightHeaviestFirst)
{
    forEachCase(kCases, [](Rng& rng) {
        Scenery scenery(rng);
        const Room room = addRoom(scenery, rng);
        scenery.look(3000);
        const FoundPlanes planes = scenery.found();
        ASSERT_EQ(planes.size(), 2u);
        EXPECT_NEAR(planes[0].weight + planes[1].weight, 1, 0.01);
        EXPECT_GE(planes[0].weight, planes[1].weight);

        // A weight on what lies on the wall makes it the first.
        for (const Vec3d& p : scenery.points)
            scenery.weights.push_back(
                std::abs(room.wall.signedDistance(p)) < 0.1 * pixelAt(scenery.search(), p) ? 1 : 1e-3f);
        const FoundPlanes weighted = scenery.found();
        ASSERT_GE(weighted.size(), 1u);
        EXPECT_GT(dot(weighted[0].planeLocal.normal, room.wall.normal), 0.999);
        EXPECT_GT(weighted[0].weight, 0.9);
    });
}

TEST(FindPlanes, CurvedAndRoughThingsShowNone)
{
    forEachCase(kCases / 20, [](Rng& rng) {
        Scenery scenery(rng);
        const int kind = rng.integer(0, 3);
        switch (kind) {
        case 0: // a dome
            scenery.addSphere({rng.uniform(-1, 1), rng.uniform(-1, 1), -6}, rng.uniform(1, 4));
            break;
        case 1: // a cylinder of many facets
        {
            const int facets = rng.integer(150, 600);
            const double radius = rng.uniform(0.8, 1.5);
            for (int i = 0; i < facets; ++i) {
                const double a = (i + 0.5) * 2 * std::numbers::pi / facets;
                const Vec3d n{std::cos(a), 0, std::sin(a)}, centre{0, 0, -4};
                const double half = 1.0001 * radius * std::sin(std::numbers::pi / facets);
                scenery.addPlane(planeThrough(centre + radius * std::cos(std::numbers::pi / facets) * n, n),
                                 [=](Vec3d p) {
                                     const Vec3d q = p - centre;
                                     return std::abs(-std::sin(a) * q.x + std::cos(a) * q.z) <= half && dot(n, p) < 0;
                                 });
            }
            break;
        }
        case 2: // ground with bumps of a few pixels
            scenery.roughness = rng.uniform(0.5, 5);
            scenery.normalNoise = rng.uniform(0.02, 0.2);
            addRoom(scenery, rng);
            break;
        default: // waves
        {
            const double height = rng.uniform(0.005, 0.03), k = rng.uniform(8, 16), phase = rng.uniform(0, 6);
            scenery.add([=](Vec3d ray) -> std::optional<Scenery::Hit> {
                if (!(ray.y < 0) || -1 / ray.y > 20) return std::nullopt;
                const auto above = [&](double t) { return t * ray.y + 1 - height * std::sin(k * t * ray.z + phase); };
                const double first = (height - 1) / ray.y, last = (-height - 1) / ray.y;
                double step = (last - first) / 200, t = first;
                while (above(t + step) > 0 && t < last) t += step;
                for (int i = 0; i < 40; ++i, step *= 0.5)
                    if (above(t + step) > 0) t += step;
                return Scenery::Hit{t, normalized({0, 1, -height * k * std::cos(k * t * ray.z + phase)})};
            });
        }
        }
        scenery.look(4000);
        ASSERT_GT(scenery.points.size(), 200u);
        // Between crest and trough, waves are straight for a while: where the picture's edge cuts them there, such a strip is
        // flat within the tolerance.
        double weight = 0;
        for (const FoundPlane& f : scenery.found()) weight += f.weight;
        EXPECT_LE(weight, kind == 3 ? 0.2 : 0.0);
    });
}

TEST(FindPlanes, ParallelPlanesAtDifferentHeightsAreTwo)
{
    forEachCase(kCases, [](Rng& rng) {
        Scenery scenery(rng);
        scenery.normalNoise = rng.chance(0.5) ? 0.02 : 0;
        const double height = rng.uniform(1, 2), step = rng.uniform(0.05, 0.3) * height, kerb = rng.uniform(-0.5, 0.5);
        const Plane road{{0, 1, 0}, height}, pavement{{0, 1, 0}, height - step};
        const auto near = [](Vec3d p) { return p.z > -20; };
        scenery.addPlane(road, near);
        scenery.addPlane(pavement, [=](Vec3d p) { return p.x > kerb && near(p); });
        scenery.look(4000);
        const FoundPlanes planes = scenery.found();
        ASSERT_EQ(planes.size(), 2u);
        for (const Plane& plane : {scenery.toLocal(road), scenery.toLocal(pavement)}) {
            const Vec3d eye = scenery.view().anchorWorld;
            const auto offBy = [&](const FoundPlane& f) {
                return std::abs(f.planeLocal.signedDistance(eye) - plane.signedDistance(eye));
            };
            const FoundPlane& f = offBy(planes[0]) < offBy(planes[1]) ? planes[0] : planes[1];
            expectSamePlane(&f, plane, scenery, 1e-6);
        }
    });
}

TEST(FindPlanes, ThePolygonHoldsAllSamplesOfThePlaneAndLiesOnIt)
{
    forEachCase(kCases, [](Rng& rng) {
        Scenery scenery(rng);
        addRoom(scenery, rng);
        addClutter(scenery, rng);
        scenery.look(4000);
        const PlaneSearch search = scenery.search();
        for (const FoundPlane& f : scenery.found()) {
            const Plane& plane = f.planeLocal;
            const std::size_t count = f.cornersLocal.size();
            ASSERT_GE(count, 3u);
            for (const Vec3d& corner : f.cornersLocal)
                EXPECT_NEAR(plane.signedDistance(corner), 0, 1e-11 * (1 + length(corner)));
            for (std::size_t i = 0; i < search.pointsLocal.size(); ++i) {
                const Vec3d p = search.pointsLocal[i];
                const double pixel = pixelAt(search, p);
                if (std::abs(plane.signedDistance(p)) > kFlatWithinPixels * pixel) continue;
                if (dot(search.normals[i], plane.normal) < 0.9999) continue;
                for (std::size_t k = 0; k < count; ++k) {
                    const Vec3d a = f.cornersLocal[k], side = f.cornersLocal[(k + 1) % count] - a;
                    EXPECT_GE(dot(cross(plane.normal, normalized(side)), p - a), -1e-9 * (1 + length(p)));
                }
            }
        }
    });
}

TEST(FindPlanes, TheOrderOfSamplesIsNothing)
{
    forEachCase(kCases, [](Rng& rng) {
        Scenery scenery(rng);
        addRoom(scenery, rng);
        addClutter(scenery, rng);
        scenery.look(3000);
        const FoundPlanes before = scenery.found();
        for (std::size_t i = scenery.points.size(); i-- > 1;) {
            const auto k = std::size_t(rng.integer(0, int(i)));
            std::swap(scenery.points[i], scenery.points[k]);
            std::swap(scenery.normals[i], scenery.normals[k]);
        }
        const FoundPlanes after = scenery.found();
        ASSERT_EQ(before.size(), after.size());
        for (std::size_t i = 0; i < before.size(); ++i) {
            EXPECT_NEAR(before[i].weight, after[i].weight, 1e-3);
            expectSamePlane(&after[i], before[i].planeLocal, scenery, 1e-6);
        }
    });
}

TEST(FindPlanes, EarlierPlanesKeepTheirNumbersUnderAnotherView)
{
    forEachCase(kCases, [](Rng& rng) {
        Scenery scenery(rng);
        addRoom(scenery, rng);
        addClutter(scenery, rng);
        scenery.look(3000);
        for (const FoundPlane& f : scenery.found()) scenery.earlier.push_back(f.planeLocal);
        ASSERT_EQ(scenery.earlier.size(), 2u);
        scenery.points.clear(), scenery.normals.clear();
        scenery.look(3000); // through other pixels
        const FoundPlanes again = scenery.found();
        ASSERT_EQ(again.size(), 2u);
        for (const FoundPlane& f : again) {
            const bool isEarlier = std::any_of(scenery.earlier.begin(), scenery.earlier.end(), [&](const Plane& p) {
                return p.normal == f.planeLocal.normal && p.offset == f.planeLocal.offset;
            });
            EXPECT_TRUE(isEarlier);
        }
    });
}

TEST(FindPlanes, AnEarlierPlaneThatMovedOrWentAwayIsNotKept)
{
    forEachCase(kCases, [](Rng& rng) {
        Scenery scenery(rng);
        const Room room = addRoom(scenery, rng);
        scenery.look(3000);
        Plane moved = room.floor;
        moved.offset += rng.uniform(0.5, 5) * kFlatWithinPixels * scenery.scale() * 1e-2; // pixels at the wall
        const Plane gone = planeThrough(scenery.view().anchorWorld, rng.onSphere());
        scenery.earlier = {moved, gone};
        const FoundPlanes planes = scenery.found();
        EXPECT_EQ(planes.size(), 2u);
        expectSamePlane(closest(planes, room.floor), room.floor, scenery, 1e-6);
        expectSamePlane(closest(planes, room.wall), room.wall, scenery, 1e-6);
    });
}

TEST(FindPlanes, LongListsAreLookedAtEvenly)
{
    forEachCase(20, [](Rng& rng) {
        Scenery scenery(rng);
        const Room room = addRoom(scenery, rng);
        scenery.look(200000);
        double onFloor = 0;
        for (const Vec3d& p : scenery.points)
            onFloor += std::abs(room.floor.signedDistance(p)) < 0.01 * pixelAt(scenery.search(), p) ? 1 : 0;
        const FoundPlanes planes = scenery.found();
        ASSERT_EQ(planes.size(), 2u);
        expectSamePlane(closest(planes, room.floor), room.floor, scenery, 1e-6);
        EXPECT_NEAR(closest(planes, room.floor)->weight, onFloor / double(scenery.points.size()), 0.03);
    });
}

TEST(FindPlanes, NothingComesOfNothing)
{
    FoundPlanes planes;
    PlaneScratch scratch;
    findPlanes({{}, {}, {}, {0, 0, 0, 1}}, scratch, planes);
    EXPECT_TRUE(planes.empty());

    const std::vector<Vec3d> line(100, Vec3d{1, 2, 3}), up(100, Vec3d{0, 1, 0});
    findPlanes({line, up, {}, {0, 0, 0, 1}}, scratch, planes);
    EXPECT_TRUE(planes.empty());

    const std::vector<Vec3d> unknown(100, Vec3d{NAN, 0, INFINITY});
    findPlanes({unknown, up, {}, {0, 0, 0, 1}}, scratch, planes);
    EXPECT_TRUE(planes.empty());
    findPlanes({line, unknown, {}, {0, 0, 0, 1}}, scratch, planes);
    EXPECT_TRUE(planes.empty());
}

// Two ways to know the size of a pixel: the linear function, and two points a pixel apart.
TEST(FindPlanes, ThePixelsSizeIsThatOfPointsAPixelApart)
{
    forEachCase(kCases, [](Rng& rng) {
        View view = anyView(rng, rng.inBox(10), rng.logUniform(1e-2, 1e2));
        view.clipFromAnchored =
            translation({rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), 0}) * view.clipFromAnchored;
        const Vec3d origin = view.anchorWorld + rng.inBox(3);
        const Mat4d localFromClip = inverse(clipFromLocal(view, origin)).value();
        const Vec3d ndc{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-0.9, 0.9)};
        const Vec3d p = project(localFromClip, ndc);
        const Vec3d beside = project(localFromClip, ndc + Vec3d{2.0 / view.width, 0, 0}),
                    above = project(localFromClip, ndc + Vec3d{0, 2.0 / view.height, 0});
        const double size = std::min(length(beside - p), length(above - p));
        EXPECT_NEAR(dot(pixelSizeLocal(view, origin), point(p)), size, 1e-6 * size);
    });
}

} // namespace
} // namespace lixel::test
