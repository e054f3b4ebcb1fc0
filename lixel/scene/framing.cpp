// SPDX-License-Identifier: MIT
#include "lixel/scene/framing.h"

#include <algorithm>
#include <cmath>

namespace lixel {

namespace {

constexpr double kMargin = 1.05;    // of free picture around a scene that is shown whole
constexpr double kSlack = 1e-3;     // of the scene's diagonal, between its ends and the near and far planes
constexpr double kNearOfFar = 1e-3; // the smallest near plane that is chosen, as a share of far

Box orUnitCube(const Box& box) { return box.isEmpty() ? Box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}} : box; }

// A single point still has some size to look at.
double sizeOf(const Box& box)
{
    return box.diagonal() > 0 ? box.diagonal() : std::max(1e-3, 1e-3 * length(box.centre()));
}

// The depths of the box's corners along the line of sight.
DepthRange depthsOf(const Box& box, const Camera& camera)
{
    const Vec3d forward = normalized(camera.targetWorld - camera.eyeWorld);
    DepthRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Vec3d& corner : box.corners()) {
        const double depth = dot(corner - camera.eyeWorld, forward);
        range = {std::min(range.near, depth), std::max(range.far, depth)};
    }
    return range;
}

} // namespace

Camera defaultCamera(const Box& sceneWorld, double aspect)
{
    const Box box = orUnitCube(sceneWorld);
    const double size = sizeOf(box);
    const Vec3d centre = box.centre(), towardsEye = normalized({0.55, 0.5, 1});
    Camera camera;
    camera.name = "automatic";

    // The nearest eye on the line from the centre from which every corner is within both fields of view.
    const Mat4d eyeFromWorld = eyeFromWorldRotation(-towardsEye, camera.up);
    const double tanY = std::tan(camera.fovy / 2) / kMargin, tanX = tanY * aspect;
    double distance = 0.5 * size;
    for (const Vec3d& corner : box.corners()) {
        const Vec3d p = transformDirection(eyeFromWorld, corner - centre);
        distance = std::max({distance, p.z + std::abs(p.x) / tanX, p.z + std::abs(p.y) / tanY});
    }
    camera.targetWorld = centre;
    camera.eyeWorld = centre + distance * towardsEye;
    return camera;
}

Light defaultSun()
{
    Light light;
    light.name = "sun";
    light.directionWorld = normalized({0.5, -1, -0.55});
    return light;
}

DepthRange depthRange(const Camera& camera, const Box& sceneWorld)
{
    const Box box = orUnitCube(sceneWorld);
    const double slack = kSlack * sizeOf(box);
    const DepthRange scene = depthsOf(box, camera);
    const bool choosesNear = !(camera.near > 0), choosesFar = std::isinf(camera.far);
    DepthRange range{camera.near, camera.far};
    if (camera.orthographicHeight > 0) {
        if (choosesFar) range.far = std::max(scene.far, choosesNear ? scene.far : camera.near) + slack;
        if (choosesNear) range.near = std::min(scene.near, range.far - slack) - slack;
        return range;
    }
    // A scene that lies behind the eye still gets a range that a projection can be made of.
    if (choosesFar) range.far = std::max({scene.far + slack, slack, 2 * camera.near});
    if (choosesNear) range.near = std::clamp(scene.near - slack, kNearOfFar * range.far, 0.5 * range.far);
    return range;
}

View makeView(const Camera& camera, int width, int height, const Box& sceneWorld)
{
    return makeView(camera, width, height, depthRange(camera, sceneWorld));
}

View makeView(const Camera& camera, int width, int height, const DepthRange& range)
{
    if (camera.orthographicHeight > 0)
        return orthographicView(camera.eyeWorld, camera.targetWorld, camera.up, camera.orthographicHeight, range.near,
                                range.far, width, height);
    return perspectiveView(camera.eyeWorld, camera.targetWorld, camera.up, camera.fovy, range.near, range.far, width,
                           height);
}

} // namespace lixel
