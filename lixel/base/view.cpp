// SPDX-License-Identifier: MIT
#include "lixel/base/view.h"

#include "lixel/base/assert.h"

namespace lixel {

Mat4d clipFromWorld(const View& view) { return view.clipFromAnchored * translation(-view.anchorWorld); }

Mat4d clipFromLocal(const View& view, Vec3d originWorld)
{
    return view.clipFromAnchored * translation(originWorld - view.anchorWorld);
}

Vec4d eyeLocal(const View& view, Vec3d originWorld)
{
    const Vec3d anchorLocal = view.anchorWorld - originWorld;
    return direction(view.eyeAnchored.w * anchorLocal) + view.eyeAnchored;
}

Vec3d towardsEye(const View& view, Vec3d originWorld, Vec3d pointLocal)
{
    const Vec4d eye = eyeLocal(view, originWorld);
    return xyz(eye) - eye.w * pointLocal;
}

Vec3d pixelFromLocal(const View& view, Vec3d originWorld, Vec3d pointLocal)
{
    const Vec3d ndc = project(clipFromLocal(view, originWorld), pointLocal);
    return {(ndc.x * 0.5 + 0.5) * view.width, (ndc.y * 0.5 + 0.5) * view.height, ndc.z};
}

Mat4d eyeFromWorldRotation(Vec3d forward, Vec3d up)
{
    const Vec3d f = normalized(forward);
    const Vec3d sideways = cross(f, up);
    LX_ASSERT(length(sideways) > 0);
    const Vec3d right = normalized(sideways);
    return Mat4d::fromRows(direction(right), direction(cross(right, f)), direction(-f), {0, 0, 0, 1});
}

View perspectiveView(Vec3d eyeWorld, Vec3d targetWorld, Vec3d up, double fovy, double near, double far, int width,
                     int height)
{
    LX_ASSERT(near > 0 && near < far && fovy > 0 && width > 0 && height > 0);
    const double focal = 1 / std::tan(fovy / 2);
    const double aspect = double(width) / height;
    // Row z for z_ndc from -1 at near to +1 at far; with an infinite far plane its limit.
    const double a = std::isinf(far) ? -1 : -(far + near) / (far - near);
    const double b = std::isinf(far) ? -2 * near : -2 * far * near / (far - near);
    const Mat4d clipFromEye = Mat4d::fromRows({focal / aspect, 0, 0, 0}, {0, focal, 0, 0}, {0, 0, a, b}, {0, 0, -1, 0});
    return {clipFromEye * eyeFromWorldRotation(targetWorld - eyeWorld, up), eyeWorld, {0, 0, 0, 1}, width, height};
}

View orthographicView(Vec3d eyeWorld, Vec3d targetWorld, Vec3d up, double heightWorld, double near, double far,
                      int width, int height)
{
    LX_ASSERT(heightWorld > 0 && near < far && width > 0 && height > 0);
    const double sy = 2 / heightWorld;
    const double sx = sy * height / width;
    const double depth = 2 / (far - near);
    const Mat4d clipFromEye =
        Mat4d::fromRows({sx, 0, 0, 0}, {0, sy, 0, 0}, {0, 0, -depth, -(far + near) / (far - near)}, {0, 0, 0, 1});
    const Mat4d rotation = eyeFromWorldRotation(targetWorld - eyeWorld, up);
    return {clipFromEye * rotation, eyeWorld, {rotation.m[2][0], rotation.m[2][1], rotation.m[2][2], 0}, width, height};
}

} // namespace lixel
