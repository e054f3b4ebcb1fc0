// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/box.h"
#include "lixel/base/light.h"
#include "lixel/base/plane.h"
#include "lixel/base/view.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

// Random views and lights over a plane, of all that lixel promises to serve.
namespace lixel::app {

// A view and a light over a plane, and the largest triangle of it that the viewer sees. Its vertices are floats, as a device draws them,
// and the plane is theirs.
struct PlaneConfiguration
{
    View view;
    Light light;
    Vec3d originWorld;
    std::array<Vec3f, 3> triangleLocal;
    Plane planeLocal; // the triangle's, unit normal either way
    double radius = 1;
    std::map<std::string, double> parameters; // what it was made with, units in the names
};

// Eye and light stand 1e-3 rad to a right angle over the plane, log-uniform; the light 0.1 to 1e6 radii away or at infinity; the scene up to
// 1e5 units from the origin; the near plane at 1e-3 to 1 radius.
PlaneConfiguration randomPlane(std::uint64_t seed, int number);

// Where the ray of sight through a place of the picture meets the plane; nothing where the viewer does not see that.
std::optional<Vec3d> seenAt(const View& view, Vec3d originWorld, const Plane& planeLocal, Vec2d pixel);

} // namespace lixel::app
