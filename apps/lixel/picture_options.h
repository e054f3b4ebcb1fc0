// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view.h"
#include "lixel/scene/evaluate.h"
#include "lixel/scene/scene.h"
#include "view_flags.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

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
    std::vector<NamedPlane>
        planes; // of interest: the scene's, and the view file's, which go before those of the same name
};

// What SCENE means: a built-in scene, or a file. Throws InputError, UsageError.
std::shared_ptr<const Scene> openScene(const std::string& text);

// Throws InputError, UsageError. `takeAll`: a built-in scene without --view gives all its views, else its first. `scene`: what
// options.scene names, where it is open already.
Shooting prepare(const PictureOptions& options, bool takeAll, std::shared_ptr<const Scene> scene = nullptr);

inline constexpr int kFramesOfPath = 30; // where nothing else is said
inline constexpr int kMostFramesOfPath = 100'000;

// Which moments of a path are shown one after the other.
struct PathOptions
{
    std::optional<int> frames; // from 2: evenly over the path, or 1 / fps apart
    std::optional<double> fps; // a second; without `frames` as many as the path has time for
    bool isStill = false;      // casters and light stay as they are where it begins
};

struct PathFrame
{
    double time = 0; // seconds
    EvaluateOptions evaluateOptions;
    Shot shot;
    View view;
};

// A scene with the frames of its path, or of the view file's, at least two. Floats of all frames are counted from one origin,
// and near and far planes that the camera leaves open are the same in all frames: as in a program that runs along the path,
// nothing changes between frames that need not.
struct PathShooting
{
    Shooting shooting; // as the path begins
    Vec3d originWorld;
    std::vector<PathFrame> frames;
    bool isStill = false;
};

// Throws InputError, UsageError. The path begins at --time, by default at its first key.
PathShooting preparePath(const PictureOptions& options, const PathOptions& path);

View viewOf(const Shooting& shooting, const Shot& shot);
Vec3d originOf(const Shooting& shooting, const Shot& shot); // what floats are counted from, World

// What the scene's file has and we leave out, in a few lines on standard error. For the end of the work: what fails says one
// line only.
void tellWarnings(const Scene& scene);

} // namespace lixel::app
