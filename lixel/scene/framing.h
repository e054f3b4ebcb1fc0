// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/box.h"
#include "lixel/base/view.h"
#include "lixel/scene/scene.h"

// Cameras and lights for scenes that bring none, and near and far planes for cameras that leave them open. An empty box
// counts as the unit cube about the origin.
namespace lixel {

// A three-quarter view from slightly above that just shows the whole box in a picture of that aspect (width / height).
Camera defaultCamera(const Box& sceneWorld, double aspect);

// A sun in the afternoon, from the left of the default camera and behind it.
Light defaultSun();

struct DepthRange
{
    double near = 0, far = 0; // along the line of sight, world units
};

// The camera's own planes where it gives them. Else far just behind the end of the scene, and near just before its
// start but at least 1e-3 of far; orthographic cameras take the scene's depths as they are, also behind the eye.
DepthRange depthRange(const Camera& camera, const Box& sceneWorld);

// Needs a camera that checkCamera() (view_file.h) finds nothing wrong with, and a picture of at least one pixel.
View makeView(const Camera& camera, int width, int height, const Box& sceneWorld);

// With depths in place of the camera's own: what serves several frames must not change between them.
View makeView(const Camera& camera, int width, int height, const DepthRange& range);

} // namespace lixel
