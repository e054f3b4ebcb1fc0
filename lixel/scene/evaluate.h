// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

namespace lixel {

// A scene at one moment, flattened once (instances, skins, morphs) into the floats that every executor draws: positions
// are worked out in double and rounded once, relative to originWorld. Triangles without area are left out; everything
// is finite.
struct SceneBuffers
{
    LocalTriangles triangles;
    std::shared_ptr<const Scene> scene; // keeps the materials and textures that casters() points into
    CasterBounds bounds;                // one box a node that is drawn, world space
    std::vector<Camera> cameras;        // the scene's, in world space at that time
    std::vector<Light> lights;          // likewise
    std::uint64_t version = 0;          // a hash of all that casters() shows: equal versions, equal content

    CasterBuffers casters() const; // a view onto this; keep the SceneBuffers alive
};

struct EvaluateOptions
{
    double time = 0;   // seconds; beyond an animation's end it repeats
    int animation = 0; // index into Scene::animations, must be one of them; ignored where there are none
};

// Bounds of the scene at that time, in world space, before an origin is known.
Box sceneBounds(const Scene& scene, const EvaluateOptions& options);

SceneBuffers evaluate(std::shared_ptr<const Scene> scene, const EvaluateOptions& options, Vec3d originWorld);

// Where floats are counted from: the eye, snapped to a grid of about a quarter of the scene, so that a moving camera
// rarely changes it. Of an eye far outside the scene, the nearest point within the scene's size of it.
Vec3d chooseOrigin(Vec3d eyeWorld, const Box& sceneWorld);

} // namespace lixel
