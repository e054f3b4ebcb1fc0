// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <memory>
#include <optional>

namespace lixel {
class TraceScene;
}

namespace lixel::app {

// A picture from inside, for scenes that are rooms: a tenth or more of a grid of places within it see surfaces' front sides
// in nearly all directions. Of these places, and directions around, the most interesting picture is taken
// (picture_interest.h); light is the sun where the sky is open above, else a spot under the ceiling above the camera.
// Nothing for scenes that are things seen from outside.
struct InteriorShot
{
    Camera camera;
    Light light;
};
std::optional<InteriorShot> interiorShot(const TraceScene& scene, const Box& sceneWorld);

} // namespace lixel::app
