// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view.h"
#include "lixel/plan/clip_convention.h"
#include "support/random_cases.h"

// Cameras of hosts: matrices as each API's own book has them, made without lixel's conversions.
namespace lixel::test {

// How a host draws. `ndcYOfRowZero`: which end of its clip space its viewports bring into row 0 of a texture.
struct Host
{
    const char* name;
    ClipConvention clip;
    TextureOrigin origin;
    double ndcYOfRowZero;
    bool isLeftHanded; // view space looks along +z
};

inline constexpr ClipDepth kWhole = ClipDepth::MinusOneToOne, kHalf = ClipDepth::ZeroToOne,
                           kReversed = ClipDepth::OneToZero;
inline constexpr TextureOrigin kBottom = TextureOrigin::Bottom, kTop = TextureOrigin::Top;

inline constexpr Host kHosts[] = {
    {"OpenGL", {kWhole, false}, kBottom, -1, false},
    {"OpenGL, depth 0..1", {kHalf, false}, kBottom, -1, false},
    {"OpenGL, reversed", {kReversed, false}, kBottom, -1, false},
    {"OpenGL, upper left", {kWhole, false}, kTop, +1, false},
    {"OpenGL drawn upside down", {kWhole, true}, kTop, -1, false},
    {"Direct3D", {kHalf, false}, kTop, +1, true},
    {"Direct3D, reversed", {kReversed, false}, kTop, +1, true},
    {"Metal, WebGPU, right-handed", {kReversed, false}, kTop, +1, false},
    {"Vulkan", {kHalf, true}, kTop, -1, false},
    {"Vulkan, reversed", {kReversed, true}, kTop, -1, false},
    {"Vulkan, not turned", {kReversed, false}, kBottom, -1, true},
    {"Direct3D with y down", {kHalf, true}, kBottom, +1, true},
    {"Metal with y down, reversed", {kReversed, true}, kBottom, +1, true},
};

enum class Lens { Perspective, OffCentre, Jittered, Oblique, Orthographic };
inline constexpr Lens kLenses[] = {Lens::Perspective, Lens::OffCentre, Lens::Jittered, Lens::Oblique,
                                   Lens::Orthographic};

// What a camera is, whoever draws it: rays from a frustum's sides at distance 1 (or a box's, if orthographic), near and far.
struct Camera
{
    Lens lens = Lens::Perspective;
    Vec3d eyeWorld;
    Mat4d rotation; // rows: right, up, backward
    double left = -1, right = 1, bottom = -1, top = 1, near = 0.1, far = 100;
    Vec2d jitterNdc;      // y up
    Vec3d obliqueNormal;  // of the near plane, in the eye's axes, inwards
    double obliqueAt = 0; // distance ahead at which it cuts the axis
    int width = 64, height = 64;
};

inline Camera anyCamera(Rng& rng, Lens lens, bool isInfinite, Vec3d centre, double radius)
{
    Camera camera;
    camera.lens = lens;
    camera.eyeWorld = centre + radius * rng.logUniform(0.1, 3) * rng.onSphere();
    const Vec3d target = centre + 0.4 * radius * rng.onSphere();
    camera.rotation = eyeFromWorldRotation(target - camera.eyeWorld, rng.onSphere());
    camera.width = rng.integer(64, 1024), camera.height = rng.integer(64, 1024);
    const bool isBox = lens == Lens::Orthographic;
    const double halfY = isBox ? radius * rng.uniform(0.2, 2) : rng.uniform(0.15, 1.2);
    const double halfX = halfY * camera.width / camera.height;
    camera.left = -halfX, camera.right = halfX, camera.bottom = -halfY, camera.top = halfY;
    camera.near = radius * rng.logUniform(1e-3, 1e-1);
    camera.far = isInfinite && !isBox ? INFINITY : radius * rng.logUniform(2, 30);
    if (lens == Lens::OffCentre || isBox) {
        const Vec2d shift{rng.uniform(-0.8, 0.8) * halfX, rng.uniform(-0.8, 0.8) * halfY};
        camera.left += shift.x, camera.right += shift.x, camera.bottom += shift.y, camera.top += shift.y;
    }
    if (lens == Lens::Jittered)
        camera.jitterNdc = {rng.uniform(-1, 1) / camera.width, rng.uniform(-1, 1) / camera.height};
    camera.obliqueNormal = normalized(Vec3d{0, 0, -1} + 0.4 * rng.inBox(1));
    camera.obliqueAt = 2 * camera.near;
    return camera;
}

// The row of clip space's z: `nearDepth` w on the near plane, `farDepth` w on the far plane. For oblique ones the near plane
// is any, and the far plane goes through the far corner that is farthest from it (Lengyel 2005).
inline Vec4d depthRow(const Camera& c, Vec4d rowW, double nearDepth, double farDepth)
{
    const double span = farDepth - nearDepth;
    if (c.lens == Lens::Oblique) {
        const Vec4d plane = direction(c.obliqueNormal) + Vec4d{0, 0, 0, c.obliqueAt * c.obliqueNormal.z};
        double mostPerW = 0;
        for (const double x : {c.left, c.right})
            for (const double y : {c.bottom, c.top}) {
                const bool isInfinite = std::isinf(c.far);
                const Vec4d corner = isInfinite ? Vec4d{x, y, -1, 0} : Vec4d{x * c.far, y * c.far, -c.far, 1};
                mostPerW = std::max(mostPerW, dot(plane, corner) / dot(rowW, corner));
            }
        return nearDepth * rowW + span / mostPerW * plane;
    }
    if (c.lens == Lens::Orthographic) { // z = depth of the distance d = -z_eye, linear
        const double slope = span / (c.far - c.near);
        return {0, 0, -slope, nearDepth - slope * c.near};
    }
    if (std::isinf(c.far)) return {0, 0, -farDepth, -span * c.near};
    // a d + b = depth d at both planes.
    const double b = (nearDepth - farDepth) * c.near * c.far / (c.far - c.near);
    const double a = farDepth - b / c.far;
    return {0, 0, -a, b};
}

// clipFromEye in the host's convention, the eye's axes right, up, backward.
inline Mat4d clipFromEye(const Camera& c, const ClipConvention& clip)
{
    const double wide = c.right - c.left, high = c.top - c.bottom;
    const bool isBox = c.lens == Lens::Orthographic;
    const Vec4d rowW = isBox ? Vec4d{0, 0, 0, 1} : Vec4d{0, 0, -1, 0};
    const double middleX = (c.right + c.left) / wide, middleY = (c.top + c.bottom) / high;
    Vec4d rowX{2 / wide, 0, isBox ? 0 : middleX, isBox ? -middleX : 0};
    Vec4d rowY{0, 2 / high, isBox ? 0 : middleY, isBox ? -middleY : 0};
    rowX = rowX + c.jitterNdc.x * rowW;
    rowY = rowY + c.jitterNdc.y * rowW;
    if (clip.yDown) rowY = -1.0 * rowY;
    const double nearDepth = clip.depth == kWhole ? -1 : clip.depth == kHalf ? 0 : 1;
    const double farDepth = clip.depth == kReversed ? 0 : 1;
    return Mat4d::fromRows(rowX, rowY, depthRow(c, rowW, nearDepth, farDepth), rowW);
}

// What a host holds: two matrices, in its convention and handedness.
struct HostMatrices
{
    Mat4d clipFromView, viewFromWorld;
};
inline HostMatrices matricesOf(const Camera& camera, const Host& host)
{
    const Mat4d axes = host.isLeftHanded ? scaling({1, 1, -1}) : Mat4d{};
    return {clipFromEye(camera, host.clip) * axes, axes * camera.rotation * translation(-camera.eyeWorld)};
}

// The same in lixel's own convention, not by way of viewFromHost().
inline View lixelView(const Camera& camera)
{
    const Vec3d back = xyz(camera.rotation.row(2));
    const Vec4d eye = camera.lens == Lens::Orthographic ? direction(back) : Vec4d{0, 0, 0, 1};
    return {clipFromEye(camera, {}) * camera.rotation, camera.eyeWorld, eye, camera.width, camera.height};
}

} // namespace lixel::test
