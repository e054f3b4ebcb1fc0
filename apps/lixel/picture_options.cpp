// SPDX-License-Identifier: MIT
#include "picture_options.h"

#include "exit_code.h"
#include "lixel/scene/builtin.h"
#include "lixel/scene/framing.h"
#include "lixel/scene/load.h"
#include "lixel/scene/view_file.h"
#include "text.h"

#include <numbers>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace lixel::app {
namespace {

constexpr int kMostPixelsASide = 8192;
constexpr double kDegrees = std::numbers::pi / 180;

bool looksLikePath(std::string_view text) { return text.find_first_of("/.") != std::string_view::npos; }

// A built-in's parameters may hold a dot, count=1.5: only what stands before the parenthesis tells a path.
Scene openScene(const std::string& text)
{
    if (looksLikePath(std::string_view(text).substr(0, text.find_first_of("(:")))) return loadScene(text);
    if (auto scene = buildBuiltin(text)) return std::move(*scene);
    std::string known;
    for (const BuiltinScene& scene : builtinScenes()) known += fmt::format("{}{}", known.empty() ? "" : ", ", scene.name);
    throw UsageError(fmt::format("scene \"{}\" is not built in (known: {}); a file's name has a / or a .", text, known));
}

std::string viewNames(const Scene& scene)
{
    std::string names;
    for (const NamedView& view : scene.views) names += (names.empty() ? "" : ", ") + view.name;
    return names.empty() ? "none" : names;
}

// The views that --view asks for by name; "all" and, where allowed, nothing mean all of them.
std::vector<Shot> namedShots(const Scene& scene, const std::string& wanted, bool takeAll)
{
    std::vector<Shot> shots;
    for (const NamedView& view : scene.views)
        if (wanted == "all" || wanted == view.name || (wanted.empty() && (takeAll || shots.empty())))
            shots.push_back({view.name, view.camera, view.lights});
    if (shots.empty() && !wanted.empty())
        throw UsageError(fmt::format("--view {}: the scene has no such view (it has: {}); a view file's name has a / or a .",
                                     wanted, viewNames(scene)));
    return shots;
}

// Camera and lights of a scene that has no named views: its own, else an automatic framing.
Shot ownShot(const Scene& scene, const EvaluateOptions& evaluateOptions, const std::shared_ptr<const Scene>& shared, const Box& sceneWorld,
             double aspect)
{
    Shot shot{"default", defaultCamera(sceneWorld, aspect), {defaultSun()}};
    if (scene.cameras.empty() && scene.lights.empty()) return shot;
    const SceneBuffers placed = evaluate(shared, evaluateOptions, chooseOrigin(sceneWorld.centre(), sceneWorld));
    if (!placed.cameras.empty()) shot.camera = placed.cameras.front();
    if (!placed.lights.empty()) shot.lights = placed.lights;
    return shot;
}

void applyViewFile(const ViewFile& file, double time, Shot& shot)
{
    if (file.camera) shot.camera = *file.camera;
    if (!file.lights.empty()) shot.lights = file.lights;
    if (!file.path.empty()) {
        shot.camera = cameraAt(file.path, time, shot.camera);
        shot.lights = lightsAt(file.path, time, shot.lights);
    }
}

void applyCameraFlags(const PictureOptions& options, Camera& camera)
{
    if (options.eye) camera.eyeWorld = readVec3(*options.eye, "--eye");
    if (options.target) camera.targetWorld = readVec3(*options.target, "--target");
    if (options.up) camera.up = readVec3(*options.up, "--up");
    if (options.fovy) camera.fovy = *options.fovy * kDegrees, camera.orthographicHeight = 0;
    if (options.near) camera.near = *options.near;
    if (options.far) camera.far = *options.far;
    if ((options.near && !(*options.near > 0)) || (options.far && !(*options.far > camera.near)))
        throw UsageError("camera: 0 < --near < --far is expected");
    if (const auto wrong = checkCamera(camera)) throw UsageError("camera: " + *wrong);
}

// One light in place of all others: position alone is a point light, direction alone a sun, both with an angle a spot.
void applyLightFlags(const PictureOptions& options, std::vector<Light>& lights)
{
    if (!options.lightPosition && !options.lightDirection) {
        if (options.lightAngle || options.lightRange)
            throw UsageError("--light-angle and --light-range go with --light-position (and --light-direction for a spot)");
        return;
    }
    Light light;
    if (options.lightDirection) light.directionWorld = readVec3(*options.lightDirection, "--light-direction");
    if (options.lightPosition) light.positionWorld = readVec3(*options.lightPosition, "--light-position");
    light.kind = !options.lightPosition ? LightKind::Directional : options.lightDirection ? LightKind::Spot : LightKind::Point;
    if (options.lightAngle && light.kind != LightKind::Spot)
        throw UsageError("--light-angle is of a spot: give --light-position and --light-direction with it");
    if (options.lightRange && light.kind == LightKind::Directional) throw UsageError("--light-range goes with --light-position");
    if (options.lightAngle) light.coneAngle = *options.lightAngle * kDegrees;
    if (options.lightRange) light.range = *options.lightRange;
    if (const auto wrong = checkLight(light)) throw UsageError("light: " + *wrong);
    light.directionWorld = normalized(light.directionWorld);
    lights = {light};
}

} // namespace

void addPictureOptions(CLI::App& command, PictureOptions& o)
{
    command.add_option("SCENE", o.scene, "a built-in scene (lixel scenes), or a .gltf, .glb or .obj file")->required();
    command.add_option("--view", o.view, "a view's name, \"all\", or a view file (JSON; its name has a / or a .)");
    command.add_option("--size", o.size, "of the picture, WIDTHxHEIGHT pixels")->capture_default_str();
    command.add_option("--time", o.time, "seconds, of animations and paths");
    command.add_option("--animation", o.animation, "which animation of the file plays, from 0");
    command.add_flag("--path", o.alongPath, "take camera and light from the scene's path at --time");
    const char* camera = "Camera (overrides the view's)";
    command.add_option("--eye", o.eye, "X,Y,Z")->group(camera);
    command.add_option("--target", o.target, "X,Y,Z")->group(camera);
    command.add_option("--up", o.up, "X,Y,Z")->group(camera);
    command.add_option("--fovy", o.fovy, "degrees, in (0, 180)")->group(camera);
    command.add_option("--near", o.near, "world units")->group(camera);
    command.add_option("--far", o.far, "world units")->group(camera);
    const char* light = "Light (takes the place of the view's lights)";
    command.add_option("--light-position", o.lightPosition, "X,Y,Z: a point light, or with a direction a spot")->group(light);
    command.add_option("--light-direction", o.lightDirection, "X,Y,Z, the way light travels: a sun, or a spot's axis")->group(light);
    command.add_option("--light-angle", o.lightAngle, "degrees, full cone of a spot")->group(light);
    command.add_option("--light-range", o.lightRange, "world units, of a point light or spot")->group(light);
}

Shooting prepare(const PictureOptions& options, bool takeAll)
{
    // Options first: a slip is told before a large file is read.
    const LixelSize size = readSize(options.size, "--size", kMostPixelsASide);
    if (options.time && !std::isfinite(*options.time)) throw UsageError("--time: a finite number is expected");
    std::optional<ViewFile> viewFile;
    if (looksLikePath(options.view)) viewFile = readViewFile(options.view);
    Shooting shooting;
    shooting.sceneName = options.scene;
    shooting.width = size.width;
    shooting.height = size.height;
    shooting.scene = std::make_shared<const Scene>(openScene(options.scene));
    const Scene& scene = *shooting.scene;
    if (options.animation && (*options.animation < 0 || *options.animation >= int(scene.animations.size())))
        throw UsageError(fmt::format("--animation {}: the scene has {}", *options.animation, scene.animations.size()));

    const double time = options.time ? *options.time : viewFile && viewFile->time ? *viewFile->time : 0.0;
    shooting.evaluateOptions = {time, options.animation.value_or(0)};
    shooting.sceneWorld = sceneBounds(scene, shooting.evaluateOptions);
    shooting.shots = namedShots(scene, viewFile ? "" : options.view, takeAll && !viewFile && !options.alongPath);
    if (shooting.shots.empty())
        shooting.shots.push_back(ownShot(scene, shooting.evaluateOptions, shooting.scene, shooting.sceneWorld,
                                         double(size.width) / size.height));
    if (options.alongPath && scene.path.empty() && !(viewFile && !viewFile->path.empty()))
        throw UsageError("--path: neither the scene nor the view file has a path");
    for (Shot& shot : shooting.shots) {
        if (options.alongPath && !scene.path.empty()) {
            shot.name = "path";
            shot.camera = cameraAt(scene.path, time, shot.camera);
            shot.lights = lightsAt(scene.path, time, shot.lights);
        }
        if (viewFile) {
            shot.name = options.view;
            applyViewFile(*viewFile, time, shot);
        }
        applyCameraFlags(options, shot.camera);
        applyLightFlags(options, shot.lights);
    }
    return shooting;
}

} // namespace lixel::app
