// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/vec.h"
#include "lixel/scene/scene.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

// Camera and light from single flags, over those of the view.
namespace lixel::app {

struct ViewFlags
{
    std::optional<std::string> eye, target, up, lightPosition, lightDirection; // "X,Y,Z"
    std::optional<double> fovy, near, far, lightAngle, lightRange;             // degrees; world units
};

void addViewFlags(CLI::App& command, ViewFlags& flags);

// The camera with the flags in place of its own values. Throws UsageError where no picture can be taken with it.
Camera withFlags(const ViewFlags& flags, Camera camera);

// The one light that takes the place of all others; nothing without light flags. A position alone is a point light, a direction
// alone a sun, both are a spot. Throws UsageError.
std::optional<Light> lightOf(const ViewFlags& flags);

// What can be told of the flags before the scene is known. Throws UsageError.
void checkFlags(const ViewFlags& flags);

} // namespace lixel::app
