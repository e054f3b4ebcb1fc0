// SPDX-License-Identifier: MIT
#include "picture_options.h"

#include "executor.h"
#include "exit_code.h"
#include "interior.h"
#include "lixel/scene/builtin.h"
#include "lixel/scene/framing.h"
#include "lixel/scene/load.h"
#include "lixel/scene/view_file.h"
#include "option_checks.h"
#include "progress.h"
#include "text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace lixel::app {
namespace {

constexpr int kMostPixelsASide = 8192;

bool looksLikePath(std::string_view text) { return text.find_first_of("/.") != std::string_view::npos; }

Scene buildScene(const std::string& text)
{
    try {
        if (auto scene = buildBuiltin(text)) return std::move(*scene);
    } catch (const InputError& error) { // there is no file: what was typed is wrong
        throw UsageError(error.what());
    }
    std::string known;
    for (const BuiltinScene& scene : builtinScenes())
        known += fmt::format("{}{}", known.empty() ? "" : ", ", scene.name);
    throw UsageError(
        fmt::format("scene \"{}\" is not built in (known: {}); a file's name has a / or a .", text, known));
}

// Cameras and lights of a file, placed at the time.
struct Placed
{
    std::vector<Camera> cameras;
    std::vector<Light> lights;
};

Placed placedIn(const Shooting& shooting)
{
    const Scene& scene = *shooting.scene;
    if (scene.cameras.empty() && scene.lights.empty()) return {};
    const Vec3d origin = chooseOrigin(shooting.sceneWorld.centre(), shooting.sceneWorld);
    SceneBuffers placed = evaluate(shooting.scene, shooting.evaluateOptions, origin);
    for (const Camera& camera : placed.cameras)
        if (const auto wrong = checkCamera(camera))
            throw InputError(fmt::format("{}: camera \"{}\": {}", shooting.sceneName, oneLine(camera.name), *wrong));
    for (const Light& light : placed.lights)
        if (const auto wrong = checkLight(light))
            throw InputError(fmt::format("{}: light \"{}\": {}", shooting.sceneName, oneLine(light.name), *wrong));
    return {std::move(placed.cameras), std::move(placed.lights)};
}

// Automatic framings: of a room from inside and then from outside, of a thing from outside only. Lights of the file stay.
std::vector<Shot> framedShots(const Shooting& shooting, const std::vector<Light>& ownLights)
{
    const auto lights = [&](const Light& automatic) { return ownLights.empty() ? std::vector{automatic} : ownLights; };
    const Camera outside = defaultCamera(shooting.sceneWorld, double(shooting.width) / shooting.height);
    std::vector<Shot> shots;
    const Vec3d origin = chooseOrigin(shooting.sceneWorld.centre(), shooting.sceneWorld);
    const Stage stage = makeStage(shooting.scene, shooting.evaluateOptions, origin);
    if (const auto inside = interiorShot(*stage.traced, shooting.sceneWorld))
        shots.push_back({"inside", inside->camera, lights(inside->light)});
    shots.push_back({shots.empty() ? "default" : "outside", outside, lights(defaultSun())});
    return shots;
}

std::vector<Light> namedLights(Placed placed)
{
    std::set<std::string> taken;
    for (Light& light : placed.lights) light.name = distinctName(light.name, taken);
    return std::move(placed.lights);
}

// All views that have a name: a built-in scene's, or each camera of a file with all its lights. Else automatic framings.
std::vector<Shot> shotsOf(const Shooting& shooting)
{
    std::vector<Shot> shots;
    for (const NamedView& view : shooting.scene->views) shots.push_back({view.name, view.camera, view.lights});
    if (!shots.empty()) return shots;

    Placed placed = placedIn(shooting);
    const std::vector<Camera> cameras = std::move(placed.cameras);
    std::vector<Light> lights = namedLights(std::move(placed));
    if (cameras.empty()) return framedShots(shooting, lights);
    if (lights.empty()) lights = {defaultSun()};
    std::set<std::string> names;
    for (const Camera& camera : cameras) shots.push_back({distinctName(camera.name, names), camera, lights});
    return shots;
}

// The shots that --view asks for by name.
std::vector<Shot> chosen(std::vector<Shot> shots, const std::string& wanted, bool takeAll)
{
    if (wanted == "all" || (wanted.empty() && takeAll)) return shots;
    if (wanted.empty()) return {shots.front()};
    std::string names;
    for (const Shot& shot : shots) {
        if (shot.name == wanted) return {shot};
        names += (names.empty() ? "" : ", ") + shot.name;
    }
    throw UsageError(fmt::format(
        "--view \"{}\": the scene has no such view (it has: {}); a view file's name has a / or a .", wanted, names));
}

// Camera and light may be at different moments of it.
struct PathTimes
{
    double camera = 0, light = 0; // seconds
};

void applyPath(std::span<const PathKey> path, PathTimes times, Shot& shot)
{
    shot.camera = cameraAt(path, times.camera, shot.camera);
    shot.lights = lightsAt(path, times.light, shot.lights);
}

void applyViewFile(const ViewFile& file, PathTimes times, Shot& shot)
{
    if (file.camera) shot.camera = *file.camera;
    if (!file.lights.empty()) shot.lights = file.lights;
    if (!file.path.empty()) applyPath(file.path, times, shot);
}

// A camera of the scene may have a name with a dot too, as "Camera.001".
std::optional<ViewFile> viewFileOf(const std::string& view)
{
    std::error_code error;
    const bool isFile = view.find('/') != view.npos || view.ends_with(".json") ||
                        (looksLikePath(view) && std::filesystem::exists(view, error));
    return isFile ? std::optional(readViewFile(view)) : std::nullopt;
}

// The scene and what was asked of it, before a time is chosen.
struct Opened
{
    Shooting shooting; // scene, its name and the picture's size
    std::optional<ViewFile> viewFile;

    // The one that moves the camera; empty where there is none.
    std::span<const PathKey> path() const
    {
        return viewFile && !viewFile->path.empty() ? viewFile->path : shooting.scene->path;
    }
};

Opened openShooting(const PictureOptions& options, std::shared_ptr<const Scene> open = nullptr)
{
    // Options first: a slip is told before a large file is read.
    const LixelSize size = readSize(options.size, "--size", kMostPixelsASide);
    if (options.time && !(*options.time >= 0 && std::isfinite(*options.time)))
        throw UsageError("--time: a finite number of seconds from 0 is expected");
    if (options.alongPath && options.view == "all")
        throw UsageError("--path gives one view: --view all does not go with it");
    checkFlags(options.flags);
    Opened out;
    out.viewFile = viewFileOf(options.view);
    out.shooting.sceneName = options.scene;
    out.shooting.width = size.width;
    out.shooting.height = size.height;
    out.shooting.scene = open ? std::move(open) : openScene(options.scene);
    const Scene& scene = *out.shooting.scene;
    if (options.animation && (*options.animation < 0 || *options.animation >= int(scene.animations.size())))
        throw UsageError(fmt::format("--animation {}: the scene has {}{}", *options.animation, scene.animations.size(),
                                     scene.animations.empty() ? "" : ", counted from 0"));
    if (out.viewFile) out.shooting.planes = out.viewFile->planes;
    for (const NamedPlane& plane : scene.planes)
        if (std::ranges::none_of(out.shooting.planes, [&](const NamedPlane& p) { return p.name == plane.name; }))
            out.shooting.planes.push_back(plane);
    if (options.alongPath && out.path().empty())
        throw UsageError("--path: neither the scene nor the view file has a path");
    return out;
}

// What path, view file and flags put in the place of a shot's own camera and lights.
void applyAll(const Opened& opened, const PictureOptions& options, PathTimes times, Shot& shot)
{
    if (options.alongPath && !opened.shooting.scene->path.empty()) {
        shot.name = "path";
        applyPath(opened.shooting.scene->path, times, shot);
    }
    if (opened.viewFile) {
        shot.name = options.view;
        applyViewFile(*opened.viewFile, times, shot);
    }
    shot.camera = withFlags(options.flags, shot.camera);
    if (const std::optional<Light> onlyLight = lightOf(options.flags)) shot.lights = {*onlyLight};
}

// The moments of the frames, at least two, none past the path's end.
std::vector<double> timesOf(std::span<const PathKey> path, std::optional<double> begin, const PathOptions& options)
{
    const double from = begin.value_or(path.front().time), to = path.back().time;
    if (!(from < to)) throw UsageError(fmt::format("--path: nothing is left of it at {} s, it ends at {} s", from, to));
    int count = options.frames.value_or(kFramesOfPath);
    if (options.fps) {
        const double fitting = std::floor((to - from) * *options.fps + 1e-6) + 1; // frames that the path has time for
        if (options.frames && fitting < count)
            throw UsageError(fmt::format("--frames {} at --fps {}: the path has time for {}", count, *options.fps,
                                         std::int64_t(std::min(fitting, 1e9))));
        if (!options.frames && !(fitting >= 2 && fitting <= kMostFramesOfPath))
            throw UsageError(fmt::format("--fps {}: expected what makes 2 to {} frames of the path's {} s",
                                         *options.fps, kMostFramesOfPath, to - from));
        if (!options.frames) count = int(fitting);
    }
    std::vector<double> times;
    for (int i = 0; i < count; ++i)
        times.push_back(options.fps ? std::min(from + i / *options.fps, to) : from + (to - from) * i / (count - 1));
    return times;
}

} // namespace

void addPictureOptions(CLI::App& command, PictureOptions& o)
{
    command.add_option("SCENE", o.scene, "a built-in scene (lixel scenes), or a .gltf, .glb or .obj file")->required();
    command.add_option("--view", o.view,
                       "the name of a view or camera of the scene, or a view file (JSON; its name has a / or a .)");
    command.add_option("--size", o.size, "of the picture, WIDTHxHEIGHT pixels")->capture_default_str();
    command.add_option("--time", o.time, "seconds from 0, of animations and paths")->check(notEmpty());
    command.add_option("--animation", o.animation, "which animation of the file plays, from 0")->check(notEmpty());
    command.add_flag("--path", o.alongPath,
                     "take camera and light from the path of the scene or the view file, at --time");
    addViewFlags(command, o.flags);
}

// A built-in's parameters may hold a dot, count=1.5: only what stands before the parenthesis tells a path.
std::shared_ptr<const Scene> openScene(const std::string& text)
{
    if (!looksLikePath(std::string_view(text).substr(0, text.find_first_of("(:"))))
        return std::make_shared<const Scene>(buildScene(text));
    return std::make_shared<const Scene>(loadScene(text));
}

Shooting prepare(const PictureOptions& options, bool takeAll, std::shared_ptr<const Scene> scene)
{
    const Progress progress("reading " + options.scene, 1);
    Opened opened = openShooting(options, std::move(scene));
    const std::optional<ViewFile>& viewFile = opened.viewFile;
    Shooting& shooting = opened.shooting;
    const double time = options.time ? *options.time : viewFile && viewFile->time ? *viewFile->time : 0.0;
    shooting.evaluateOptions = {time, options.animation.value_or(0)};
    shooting.sceneWorld = sceneBounds(*shooting.scene, shooting.evaluateOptions);
    const bool takesBuiltins = takeAll && !shooting.scene->views.empty() && !viewFile && !options.alongPath;
    shooting.shots = chosen(shotsOf(shooting), viewFile ? "" : options.view, takesBuiltins);
    for (Shot& shot : shooting.shots) applyAll(opened, options, {time, time}, shot);
    return std::move(shooting);
}

PathShooting preparePath(const PictureOptions& options, const PathOptions& path)
{
    const Progress progress("reading " + options.scene, 1);
    Opened opened = openShooting(options);
    const std::vector<double> times = timesOf(opened.path(), options.time, path);
    Shooting& shooting = opened.shooting;
    const Scene& scene = *shooting.scene;
    shooting.evaluateOptions = {times.front(), options.animation.value_or(0)};
    shooting.sceneWorld = sceneBounds(scene, shooting.evaluateOptions);
    const Shot first = chosen(shotsOf(shooting), opened.viewFile ? "" : options.view, false).front();

    PathShooting out;
    out.isStill = path.isStill;
    const bool sceneMoves = !path.isStill && (scene.animate || !scene.animations.empty());
    const bool lightsMove = sceneMoves && scene.views.empty() && !scene.lights.empty(); // with nodes of the file
    Box eyes;
    DepthRange depths{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    const Box sceneAtBegin = shooting.sceneWorld;
    for (const double time : times) {
        if (sceneMoves && time > times.front()) {
            shooting.evaluateOptions.time = time;
            shooting.sceneWorld = sceneBounds(scene, shooting.evaluateOptions);
        }
        PathFrame& frame = out.frames.emplace_back(PathFrame{time, shooting.evaluateOptions, first, {}});
        if (lightsMove) frame.shot.lights = namedLights(placedIn(shooting));
        applyAll(opened, options, {time, path.isStill ? times.front() : time}, frame.shot);
        if (frame.shot.lights.size() != out.frames.front().shot.lights.size())
            throw InputError(shooting.sceneName + ": lights come and go along the path, which cannot be compared");
        eyes.include(frame.shot.camera.eyeWorld);
        const DepthRange here = depthRange(frame.shot.camera, shooting.sceneWorld);
        depths = {std::min(depths.near, here.near), std::max(depths.far, here.far)};
    }
    for (PathFrame& frame : out.frames)
        frame.view = makeView(frame.shot.camera, shooting.width, shooting.height, depths);
    shooting.evaluateOptions = out.frames.front().evaluateOptions;
    shooting.sceneWorld = sceneAtBegin;
    shooting.shots = {out.frames.front().shot};
    out.originWorld = chooseOrigin(eyes.centre(), shooting.sceneWorld);
    out.shooting = std::move(shooting);
    return out;
}

View viewOf(const Shooting& shooting, const Shot& shot)
{
    return makeView(shot.camera, shooting.width, shooting.height, shooting.sceneWorld);
}

Vec3d originOf(const Shooting& shooting, const Shot& shot)
{
    return chooseOrigin(shot.camera.eyeWorld, shooting.sceneWorld);
}

void tellWarnings(const Scene& scene)
{
    constexpr std::size_t kMost = 5;
    const std::size_t told = std::min(scene.warnings.size(), kMost);
    for (std::size_t i = 0; i < told; ++i)
        std::fputs(("lixel: note: " + oneLine(scene.warnings[i]) + "\n").c_str(), stderr);
    if (const std::size_t more = scene.warnings.size() - told)
        std::fputs(fmt::format("lixel: note: and {} more of this kind\n", more).c_str(), stderr);
}

} // namespace lixel::app
