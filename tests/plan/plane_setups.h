// SPDX-License-Identifier: MIT
#pragma once

#include "plan/awkward_setups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

// Random setups with a plane of interest: the plane in either orientation; the light before and behind it, at the world's origin,
// nearly in it, a million scenes away; the eye nearly in it; any projective camera.
namespace lixel::test {

struct PlaneSetup : RandomSetup
{
    Plane planeLocal;
};

// How the fit asks for the map of a plane of a setup; all share one scratch.
inline FitInput inputOf(const PlaneSetup& setup, Twist twist, bool wantsWholePixels)
{
    FitInput input = inputOf(static_cast<const RandomSetup&>(setup));
    input.plane = PlaneOfCell{setup.planeLocal, twist, {}};
    input.wantsWholePixels = wantsWholePixels;
    return input;
}

inline Vec4d rowOf(const Plane& plane) { return {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset}; }

// L of the closed form, Local; of the size of the scene's neighbourhood, not of the light's distance.
inline Vec4d lightLocal(const RandomSetup& setup)
{
    if (setup.light.kind == LightKind::Directional) return direction(-setup.light.directionWorld);
    const Vec3d p = setup.light.positionWorld - setup.originWorld;
    return (1 / std::max(1.0, length(p))) * point(p);
}

// Sine of the elevation above the plane, as seen from about the scene's size away.
inline double sineAbove(const PlaneSetup& setup, Vec4d p)
{
    return dot(rowOf(setup.planeLocal), p) / (length(xyz(p)) + std::abs(p.w) * setup.radius);
}

// The homogeneous point that lies in three planes.
inline Vec4d meet(Vec4d a, Vec4d b, Vec4d c)
{
    const auto minor = [&](int i, int j, int k) {
        const auto at = [](Vec4d v, int n) { return n == 0 ? v.x : n == 1 ? v.y : n == 2 ? v.z : v.w; };
        return dot(Vec3d{at(a, i), at(a, j), at(a, k)},
                   cross(Vec3d{at(b, i), at(b, j), at(b, k)}, Vec3d{at(c, i), at(c, j), at(c, k)}));
    };
    return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
}

// Where the ray of sight through a place of the picture meets the plane, homogeneous: beyond the vanishing line behind the viewer.
inline Vec4d seenAt(const PlaneSetup& setup, Vec2d pixel)
{
    // About the eye, which keeps all digits.
    const Vec3d anchorLocal = setup.view.anchorWorld - setup.originWorld;
    const Mat4d& m = setup.view.clipFromAnchored;
    const auto side = [&](int row, double p, int size) { return m.row(row) + (1 - 2 * p / size) * m.row(3); };
    Vec4d plane = rowOf(setup.planeLocal);
    plane.w += dot(xyz(plane), anchorLocal);
    const Vec4d p = meet(side(0, pixel.x, setup.view.width), side(1, pixel.y, setup.view.height), plane);
    return p + direction(p.w * anchorLocal);
}

// The same before the viewer and not very far away; nothing where there is no such point.
inline std::optional<Vec3d> pointSeenAt(const PlaneSetup& setup, Vec2d pixel, double mostRadii = 1e3)
{
    const Vec4d p = seenAt(setup, pixel);
    const Vec3d q = xyz(p) / p.w;
    const Vec4d clip = clipFromLocal(setup.view, setup.originWorld) * point(q);
    if (!isFinite(q) || !(clip.w > 0) || length(q) > mostRadii * setup.radius) return std::nullopt;
    return q;
}

inline Vec2d anyPixel(const View& view, Rng& rng) { return {rng.uniform(0, view.width), rng.uniform(0, view.height)}; }

// A plane at one of the places that are hard.
inline Plane anyPlane(const RandomSetup& setup, Rng& rng)
{
    const Vec3d n = rng.chance(0.3) ? Vec3d{0, rng.chance(0.5) ? 1.0 : -1.0, 0} : rng.onSphere();
    const Box scene = setup.sceneLocal();
    const Vec3d in = scene.centre() + 0.3 * setup.radius * rng.inBox(1);
    const Vec3d eye = setup.view.anchorWorld - setup.originWorld;
    const double nearly = setup.radius * rng.logUniform(1e-5, 1e-1);
    const int kind = rng.integer(0, 9);
    if (kind == 0) return planeThrough(eye + nearly * n, n); // eye nearly in the plane
    if (kind == 1) {                                         // light nearly in the plane
        const Vec4d l = lightLocal(setup);
        const Vec3d towards = normalized(xyz(l) - l.w * in);
        const Vec3d beside = anyPerpendicular(towards);
        return planeThrough(in, normalized(beside + rng.logUniform(1e-5, 1e-1) * towards));
    }
    return planeThrough(in, n);
}

inline PlaneSetup anyPlaneSetup(Rng& rng)
{
    PlaneSetup setup;
    static_cast<RandomSetup&>(setup) = anySetup(rng);
    const int kind = rng.integer(0, 9);
    if (kind == 0) { // the world's origin is where a point light is
        const Vec3d by = -setup.light.positionWorld;
        setup.light.positionWorld = {};
        for (Box& box : setup.boxesWorld) box = translated(box, by);
        setup.view.anchorWorld = setup.view.anchorWorld + by;
        setup.originWorld = setup.originWorld + by;
    }
    if (kind == 1) { // oblique, jittered, off-centre, along the axes
        const Camera camera = awkwardCamera(rng, setup.sceneLocal().centre() + setup.originWorld, setup.radius);
        setup.view = lixelView(camera);
        setup.originWorld = setup.view.anchorWorld;
    }
    setup.planeLocal = anyPlane(setup, rng);
    return setup;
}

} // namespace lixel::test
