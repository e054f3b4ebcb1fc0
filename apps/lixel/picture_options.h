// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view.h"
#include "lixel/scene/evaluate.h"
#include "lixel/scene/scene.h"
#include "view_flags.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

// What a picture is taken of: the scene, its views, lights and the time, from options, view file and scene, in this order of
// precedence.
namespace lixel::app {

struct PictureOptions
{
    std::string scene;
    std::string view; // a view's or camera's name, a view file's path, or "all"
    std::string size = "1024x1024";
    std::optional<double> time;
    std::optional<int> animation;
    bool alongPath = false;
    ViewFlags flags;
};

void addPictureOptions(CLI::App& command, PictureOptions& options);

// One picture to take.
struct Shot
{
    std::string name; // the view's
    Camera camera;
    std::vector<Light> lights; // at least one; names differ
};

// A scene at its time with all the pictures asked for.
struct Shooting
{
    std::string sceneName; // as typed
    std::shared_ptr<const Scene> scene;
    EvaluateOptions evaluateOptions;
    Box sceneWorld; // at that time
    int width = 0, height = 0;
    std::vector<Shot> shots; // at least one; names differ
};

// Throws InputError, UsageError. `takeAll`: a built-in scene without --view gives all its views, else its first.
Shooting prepare(const PictureOptions& options, bool takeAll);

View viewOf(const Shooting& shooting, const Shot& shot);
Vec3d originOf(const Shooting& shooting, const Shot& shot); // what floats are counted from, World

// What the scene's file has and we leave out, in a few lines on standard error. For the end of the work: what fails says one
// line only.
void tellWarnings(const Scene& scene);

} // namespace lixel::app
