// SPDX-License-Identifier: MIT
#include "view_flags.h"

#include "exit_code.h"
#include "lixel/scene/view_file.h"
#include "option_checks.h"
#include "text.h"

#include <numbers>

#include <CLI/CLI.hpp>

namespace lixel::app {
namespace {

constexpr double kDegrees = std::numbers::pi / 180;

std::optional<Vec3d> readIf(const std::optional<std::string>& text, std::string_view option)
{
    return text ? std::optional(readVec3(*text, option)) : std::nullopt;
}

} // namespace

void addViewFlags(CLI::App& command, ViewFlags& flags)
{
    const char* camera = "Camera (each in place of the view's)";
    command.add_option("--eye", flags.eye, "X,Y,Z")->group(camera);
    command.add_option("--target", flags.target, "X,Y,Z")->group(camera);
    command.add_option("--up", flags.up, "X,Y,Z")->group(camera);
    command.add_option("--fovy", flags.fovy, "degrees, more than 0 and less than 180")
        ->check(notEmpty())
        ->group(camera);
    command.add_option("--near", flags.near, "world units")->check(notEmpty())->group(camera);
    command.add_option("--far", flags.far, "world units")->check(notEmpty())->group(camera);
    const char* light = "Light (one, in place of all the view's)";
    command.add_option("--light-position", flags.lightPosition, "X,Y,Z: a point light, or with a direction a spot")
        ->group(light);
    command
        .add_option("--light-direction", flags.lightDirection, "X,Y,Z, the way light travels: a sun, or a spot's axis")
        ->group(light);
    command.add_option("--light-angle", flags.lightAngle, "degrees, full cone of a spot (90)")
        ->check(notEmpty())
        ->group(light);
    command.add_option("--light-range", flags.lightRange, "world units, of a point light or spot (no end)")
        ->check(notEmpty())
        ->group(light);
}

Camera withFlags(const ViewFlags& flags, Camera camera)
{
    camera.eyeWorld = readIf(flags.eye, "--eye").value_or(camera.eyeWorld);
    camera.targetWorld = readIf(flags.target, "--target").value_or(camera.targetWorld);
    camera.up = readIf(flags.up, "--up").value_or(camera.up);
    if (flags.fovy) camera.fovy = *flags.fovy * kDegrees, camera.orthographicHeight = 0;
    camera.near = flags.near.value_or(camera.near);
    camera.far = flags.far.value_or(camera.far);
    if (const auto wrong = checkCamera(camera)) throw UsageError("camera: " + *wrong);
    return camera;
}

std::optional<Light> lightOf(const ViewFlags& flags)
{
    if (!flags.lightPosition && !flags.lightDirection) {
        if (flags.lightAngle || flags.lightRange)
            throw UsageError(
                "--light-angle and --light-range go with --light-position (and --light-direction for a spot)");
        return std::nullopt;
    }
    Light light;
    if (flags.lightDirection) light.directionWorld = readVec3(*flags.lightDirection, "--light-direction");
    if (flags.lightPosition) light.positionWorld = readVec3(*flags.lightPosition, "--light-position");
    light.kind = !flags.lightPosition   ? LightKind::Directional
                 : flags.lightDirection ? LightKind::Spot
                                        : LightKind::Point;
    if (flags.lightAngle && light.kind != LightKind::Spot)
        throw UsageError("--light-angle is of a spot: give --light-position and --light-direction with it");
    if (flags.lightRange && light.kind == LightKind::Directional)
        throw UsageError("--light-range goes with --light-position");
    if (flags.lightAngle) light.coneAngle = *flags.lightAngle * kDegrees;
    if (flags.lightRange) light.range = *flags.lightRange;
    if (const auto wrong = checkLight(light)) throw UsageError("light: " + *wrong);
    light.directionWorld = normalized(light.directionWorld);
    return light;
}

void checkFlags(const ViewFlags& flags)
{
    lightOf(flags);
    // 0 asks for a chosen near plane inside; nobody means that who writes it.
    if (flags.near && !(*flags.near > 0)) throw UsageError("--near: a number above 0 is expected");
    if (flags.far && !(*flags.far > flags.near.value_or(0)))
        throw UsageError("--far: more than --near, and than 0, is expected");
    // Where eye and target are and which way is up belong together, and the view may give some of them.
    const auto eye = readIf(flags.eye, "--eye"), target = readIf(flags.target, "--target");
    readIf(flags.up, "--up");
    if (eye && target && *eye == *target) throw UsageError("camera: expected eye and target to be different points");
    ViewFlags numbers;
    numbers.fovy = flags.fovy;
    numbers.near = flags.near;
    numbers.far = flags.far;
    withFlags(numbers, Camera());
}

} // namespace lixel::app
