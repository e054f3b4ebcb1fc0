// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <memory>
#include <optional>

namespace lixel {
class TraceScene;
}

namespace lixel::app {

// A picture from inside, for scenes that are rooms: whose middle sees surfaces' front sides in nearly all directions. A camera
// at eye height looks along the longest free way; light is the sun where the sky is open above, else a spot under the ceiling
// behind the camera. Nothing for scenes that are things seen from outside.
struct InteriorShot
{
    Camera camera;
    Light light;
};
std::optional<InteriorShot> interiorShot(const TraceScene& scene, const Box& sceneWorld);

} // namespace lixel::app
