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
#include "text.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
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

// A built-in's parameters may hold a dot, count=1.5: only what stands before the parenthesis tells a path.
Scene openScene(const std::string& text)
{
    if (!looksLikePath(std::string_view(text).substr(0, text.find_first_of("(:")))) return buildScene(text);
    return loadScene(text);
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

// All views that have a name: a built-in scene's, or each camera of a file with all its lights. Else automatic framings.
std::vector<Shot> shotsOf(const Shooting& shooting)
{
    std::vector<Shot> shots;
    for (const NamedView& view : shooting.scene->views) shots.push_back({view.name, view.camera, view.lights});
    if (!shots.empty()) return shots;

    Placed placed = placedIn(shooting);
    std::set<std::string> viewNames, lightNames;
    for (Light& light : placed.lights) light.name = distinctName(light.name, lightNames);
    if (placed.cameras.empty()) return framedShots(shooting, placed.lights);
    if (placed.lights.empty()) placed.lights = {defaultSun()};
    for (const Camera& camera : placed.cameras)
        shots.push_back({distinctName(camera.name, viewNames), camera, placed.lights});
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

void applyPath(std::span<const PathKey> path, double time, Shot& shot)
{
    shot.camera = cameraAt(path, time, shot.camera);
    shot.lights = lightsAt(path, time, shot.lights);
}

void applyViewFile(const ViewFile& file, double time, Shot& shot)
{
    if (file.camera) shot.camera = *file.camera;
    if (!file.lights.empty()) shot.lights = file.lights;
    if (!file.path.empty()) applyPath(file.path, time, shot);
}

// A camera of the scene may have a name with a dot too, as "Camera.001".
std::optional<ViewFile> viewFileOf(const std::string& view)
{
    std::error_code error;
    const bool isFile = view.find('/') != view.npos || view.ends_with(".json") ||
                        (looksLikePath(view) && std::filesystem::exists(view, error));
    return isFile ? std::optional(readViewFile(view)) : std::nullopt;
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
    command.add_flag("--path", o.alongPath, "take camera and light from the scene's path at --time");
    addViewFlags(command, o.flags);
}

Shooting prepare(const PictureOptions& options, bool takeAll)
{
    // Options first: a slip is told before a large file is read.
    const LixelSize size = readSize(options.size, "--size", kMostPixelsASide);
    if (options.time && !(*options.time >= 0 && std::isfinite(*options.time)))
        throw UsageError("--time: a finite number of seconds from 0 is expected");
    if (options.alongPath && options.view == "all")
        throw UsageError("--path gives one view: --view all does not go with it");
    checkFlags(options.flags);
    const std::optional<ViewFile> viewFile = viewFileOf(options.view);
    Shooting shooting;
    shooting.sceneName = options.scene;
    shooting.width = size.width;
    shooting.height = size.height;
    shooting.scene = std::make_shared<const Scene>(openScene(options.scene));
    const Scene& scene = *shooting.scene;
    if (options.animation && (*options.animation < 0 || *options.animation >= int(scene.animations.size())))
        throw UsageError(fmt::format("--animation {}: the scene has {}{}", *options.animation, scene.animations.size(),
                                     scene.animations.empty() ? "" : ", counted from 0"));
    if (options.alongPath && scene.path.empty() && !(viewFile && !viewFile->path.empty()))
        throw UsageError("--path: neither the scene nor the view file has a path");

    const double time = options.time ? *options.time : viewFile && viewFile->time ? *viewFile->time : 0.0;
    shooting.evaluateOptions = {time, options.animation.value_or(0)};
    shooting.sceneWorld = sceneBounds(scene, shooting.evaluateOptions);
    const bool takesBuiltins = takeAll && !scene.views.empty() && !viewFile && !options.alongPath;
    shooting.shots = chosen(shotsOf(shooting), viewFile ? "" : options.view, takesBuiltins);
    const std::optional<Light> onlyLight = lightOf(options.flags);
    for (Shot& shot : shooting.shots) {
        if (options.alongPath && !scene.path.empty()) {
            shot.name = "path";
            applyPath(scene.path, time, shot);
        }
        if (viewFile) {
            shot.name = options.view;
            applyViewFile(*viewFile, time, shot);
        }
        shot.camera = withFlags(options.flags, shot.camera);
        if (onlyLight) shot.lights = {*onlyLight};
    }
    return shooting;
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
