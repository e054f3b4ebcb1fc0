// SPDX-License-Identifier: MIT
#include "lixel/scene/view_file.h"

#include "lixel/scene/input_file.h"
#include "lixel/scene/json_text.h"
#include "lixel/scene/view_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

namespace lixel {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLeastNear = 1e-9; // world units; below, a projection loses its rank in double
constexpr double kParallel = 1e-9;  // sine of an angle that counts as none
constexpr double kOffPlane = 1e-3;  // how far, of its size, a polygon's corners may be from its plane

double radians(double degrees) { return degrees * kPi / 180; }

bool isSane(Vec3d v)
{
    return std::abs(v.x) <= kMostAbsolute && std::abs(v.y) <= kMostAbsolute && std::abs(v.z) <= kMostAbsolute;
}

Vec3d mix(Vec3d a, Vec3d b, double s) { return (1 - s) * a + s * b; }

// Between the two, a line of sight or a direction shrinks to nothing.
bool passesZero(Vec3d from, Vec3d to)
{
    const Vec3d step = to - from;
    const double s = dot(step, step) > 0 ? std::clamp(-dot(from, step) / dot(step, step), 0.0, 1.0) : 0;
    return !(length(mix(from, to, s)) > kParallel * std::max(length(from), length(to)));
}

Camera readCamera(const JsonPlace& place)
{
    place.expectMembers({"eye", "target", "up", "fovy", "near", "far", "orthographic"});
    Camera camera;
    camera.eyeWorld = place.at("eye").vector();
    camera.targetWorld = place.at("target").vector();
    if (const auto up = place.find("up")) camera.up = up->unitVector();
    if (const auto fovy = place.find("fovy")) camera.fovy = radians(fovy->numberAbove(0));
    if (const auto near = place.find("near")) camera.near = near->numberAbove(0);
    if (const auto far = place.find("far")) camera.far = far->numberAbove(0);
    if (const auto height = place.find("orthographic")) {
        if (place.has("fovy")) place.refuse("expected one of \"fovy\" and \"orthographic\"");
        camera.orthographicHeight = height->numberAbove(0);
    }
    if (const auto wrong = checkCamera(camera)) place.refuse(*wrong);
    return camera;
}

Light readLight(const JsonPlace& place)
{
    place.expectMembers({"name", "position", "direction", "angle", "range"});
    const auto position = place.find("position"), direction = place.find("direction");
    const auto angle = place.find("angle"), range = place.find("range");
    if (!position && !direction) place.refuse("expected \"position\", \"direction\", or both with \"angle\"");
    const bool isSpot = position && direction;
    if (isSpot && !angle) place.refuse("expected \"angle\", as it has both \"position\" and \"direction\"");
    if (!isSpot && angle) angle->refuse("expected no angle but of a spot, which has \"position\" and \"direction\"");
    if (!position && range) range->refuse("expected no range of a light that has no \"position\"");

    Light light;
    light.kind = isSpot ? LightKind::Spot : position ? LightKind::Point : LightKind::Directional;
    if (const auto name = place.find("name")) light.name = name->name();
    if (position) light.positionWorld = position->vector();
    if (direction) light.directionWorld = direction->unitVector();
    if (angle) light.coneAngle = radians(angle->numberAbove(0));
    if (range) light.range = range->numberAbove(0);
    if (const auto wrong = checkLight(light)) place.refuse(*wrong);
    return light;
}

NamedPlane readPlane(const JsonPlace& place)
{
    place.expectMembers({"name", "point", "normal", "polygon"});
    NamedPlane plane{place.at("name").name(), place.at("point").vector(), place.at("normal").unitVector(), {}};
    const auto polygon = place.find("polygon");
    if (!polygon) return plane;
    double size = 0;
    for (const JsonPlace& corner : polygon->elements(3)) {
        plane.polygonWorld.push_back(corner.vector());
        size = std::max(size, length(plane.polygonWorld.back() - plane.polygonWorld.front()));
    }
    for (const Vec3d& corner : plane.polygonWorld)
        if (!(std::abs(dot(corner - plane.pointWorld, plane.normalWorld)) <= kOffPlane * size))
            polygon->refuse("expected corners in the plane of \"point\" and \"normal\"");
    return plane;
}

std::vector<NamedPlane> readPlanes(const JsonPlace& file)
{
    std::vector<NamedPlane> planes;
    std::set<std::string> names;
    if (const auto places = file.find("planes"))
        for (const JsonPlace& place : places->elements(0)) {
            planes.push_back(readPlane(place));
            if (!names.insert(planes.back().name).second)
                place.refuse(fmt::format("expected another name: \"{}\" is taken", planes.back().name));
        }
    return planes;
}

// A bare [x, y, z] is of the kind that the file's first light has.
void readKeyLight(const JsonPlace& place, const std::vector<Light>& lights, PathKey& key)
{
    if (place.isArray()) {
        if (lights.empty())
            place.refuse("expected {\"position\": ...} or {\"direction\": ...}, as the file has no light");
        if (lights.front().kind == LightKind::Directional) key.lightDirectionWorld = place.unitVector();
        else key.lightPositionWorld = place.vector();
        return;
    }
    place.expectMembers({"position", "direction"});
    const auto position = place.find("position"), direction = place.find("direction");
    if (position) key.lightPositionWorld = position->vector();
    if (direction) key.lightDirectionWorld = direction->unitVector();
    if (!key.lightPositionWorld && !key.lightDirectionWorld) place.refuse("expected \"position\" or \"direction\"");
    if (lights.empty()) return;
    if (position && lights.front().kind == LightKind::Directional)
        position->refuse("expected \"direction\", as the file's first light has no position");
    if (direction && lights.front().kind == LightKind::Point)
        direction->refuse("expected \"position\", as the file's first light has no direction");
}

PathKey readKey(const JsonPlace& place, const ViewFile& file)
{
    place.expectMembers({"time", "eye", "target", "light"});
    PathKey key;
    key.time = place.at("time").number();
    if (key.time < 0) place.at("time").refuse("expected a time of at least 0");
    key.eyeWorld = place.at("eye").vector();
    key.targetWorld = place.at("target").vector();
    if (const auto light = place.find("light")) readKeyLight(*light, file.lights, key);
    if (const auto wrong = checkCamera(cameraAt({&key, 1}, key.time, file.camera.value_or(Camera()))))
        place.refuse(*wrong);
    return key;
}

// What only two neighbours can do wrong.
void checkStep(const JsonPlace& place, const PathKey& before, const PathKey& key)
{
    if (!(key.time > before.time)) place.refuse("expected a time after that of the key before");
    if (key.lightPositionWorld.has_value() != before.lightPositionWorld.has_value() ||
        key.lightDirectionWorld.has_value() != before.lightDirectionWorld.has_value())
        place.refuse("expected a light of the same kind in every key, or in none");
    if (passesZero(before.targetWorld - before.eyeWorld, key.targetWorld - key.eyeWorld))
        place.refuse("expected eye and target not to meet on the way from the key before");
    if (key.lightDirectionWorld && passesZero(*before.lightDirectionWorld, *key.lightDirectionWorld))
        place.refuse("expected a light direction that is not opposite to the one before");
}

std::vector<PathKey> readPath(const JsonPlace& place, const ViewFile& file)
{
    std::vector<PathKey> path;
    for (const JsonPlace& keyPlace : place.elements(1)) {
        path.push_back(readKey(keyPlace, file));
        if (path.size() > 1) checkStep(keyPlace, path[path.size() - 2], path.back());
    }
    return path;
}

} // namespace

// Lights without a name are "light", "light-2", ...; names tell lights apart in results.
std::vector<Light> readLights(const JsonPlace& file)
{
    std::vector<JsonPlace> places;
    if (const auto one = file.find("light")) places = {*one};
    if (const auto several = file.find("lights")) {
        if (!places.empty()) file.refuse("expected one of \"light\" and \"lights\"");
        places = several->elements(1);
    }
    std::vector<Light> lights;
    std::set<std::string> names;
    for (const JsonPlace& place : places) {
        Light light = readLight(place);
        if (!place.has("name") && !lights.empty()) light.name = fmt::format("light-{}", lights.size() + 1);
        if (!names.insert(light.name).second)
            place.refuse(fmt::format("expected another name: \"{}\" is taken", light.name));
        lights.push_back(light);
    }
    return lights;
}

ViewFile readViewFile(const std::string& path) { return parseViewFile(readJsonFile(path), path); }

ViewFile parseViewFile(std::string_view text, const std::string& name)
{
    const nlohmann::json json = parseJson(text, name);
    const JsonPlace place(json, "", name);
    place.expectMembers({"camera", "light", "lights", "planes", "time", "path"});
    ViewFile file;
    if (const auto camera = place.find("camera")) file.camera = readCamera(*camera);
    file.lights = readLights(place);
    file.planes = readPlanes(place);
    if (const auto time = place.find("time")) {
        file.time = time->number();
        if (*file.time < 0) time->refuse("expected a time of at least 0");
    }
    if (const auto path = place.find("path")) file.path = readPath(*path, file);
    return file;
}

std::optional<std::string> checkCamera(const Camera& camera)
{
    if (!isSane(camera.eyeWorld) || !isSane(camera.targetWorld) || !isSane(camera.up))
        return fmt::format("expected eye, target and up to be finite numbers of at most {}", kMostAbsolute);
    const Vec3d sight = camera.targetWorld - camera.eyeWorld;
    if (!(length(sight) > 0)) return "expected eye and target to be different points";
    if (!(length(cross(normalized(sight), normalized(camera.up))) > kParallel))
        return "expected up not to be zero or along the line of sight";
    const double tangent = std::tan(camera.fovy / 2);
    if (!(camera.fovy > 0 && camera.fovy < kPi && tangent > kParallel && tangent < 1 / kParallel))
        return "expected fovy to be more than 0 and less than 180 degrees";
    if (!(camera.orthographicHeight >= 0 && camera.orthographicHeight <= kMostAbsolute))
        return fmt::format("expected the orthographic height to be more than 0 and at most {}", kMostAbsolute);
    if (!(camera.near == 0 || (camera.near >= kLeastNear && camera.near <= kMostAbsolute)))
        return fmt::format("expected near to be at least {} and at most {}", kLeastNear, kMostAbsolute);
    if (!(camera.far > camera.near)) return "expected far to be greater than near";
    if (camera.near == 0 && camera.far < kLeastNear) return fmt::format("expected far to be at least {}", kLeastNear);
    return std::nullopt;
}

std::optional<std::string> checkLight(const Light& light)
{
    const bool hasPlace = light.kind != LightKind::Directional, hasDirection = light.kind != LightKind::Point;
    if (hasPlace && !isSane(light.positionWorld))
        return fmt::format("expected a position of finite numbers of at most {}", kMostAbsolute);
    if (hasDirection && !(isSane(light.directionWorld) && length(light.directionWorld) > 0))
        return "expected a direction of finite numbers, not [0, 0, 0]";
    if (light.kind == LightKind::Spot && !(light.coneAngle > kParallel && light.coneAngle < kPi))
        return "expected an angle of more than 0 and less than 180 degrees";
    if (hasPlace && !(light.range > 0)) return "expected a range greater than 0";
    return std::nullopt;
}

PathKey keyAt(std::span<const PathKey> path, double time)
{
    LX_ASSERT(!path.empty());
    const auto after = std::ranges::upper_bound(path, time, {}, &PathKey::time);
    if (after == path.begin()) return path.front();
    if (after == path.end()) return path.back();
    const PathKey &a = *std::prev(after), &b = *after;
    const double s = (time - a.time) / (b.time - a.time);
    PathKey key{time, mix(a.eyeWorld, b.eyeWorld, s), mix(a.targetWorld, b.targetWorld, s), {}, {}};
    if (a.lightPositionWorld && b.lightPositionWorld)
        key.lightPositionWorld = mix(*a.lightPositionWorld, *b.lightPositionWorld, s);
    if (a.lightDirectionWorld && b.lightDirectionWorld)
        key.lightDirectionWorld = normalized(mix(*a.lightDirectionWorld, *b.lightDirectionWorld, s));
    return key;
}

Camera cameraAt(std::span<const PathKey> path, double time, const Camera& camera)
{
    const PathKey key = keyAt(path, time);
    Camera moved = camera;
    moved.eyeWorld = key.eyeWorld;
    moved.targetWorld = key.targetWorld;
    return moved;
}

std::vector<Light> lightsAt(std::span<const PathKey> path, double time, std::vector<Light> lights)
{
    if (lights.empty()) return lights;
    const PathKey key = keyAt(path, time);
    Light& first = lights.front();
    const bool places = key.lightPositionWorld.has_value(), directs = key.lightDirectionWorld.has_value();
    if (places && first.kind == LightKind::Directional) first.kind = LightKind::Point;
    if (directs && !places && first.kind == LightKind::Point) first.kind = LightKind::Directional;
    if (key.lightPositionWorld) first.positionWorld = *key.lightPositionWorld;
    if (key.lightDirectionWorld) first.directionWorld = *key.lightDirectionWorld;
    return lights;
}

} // namespace lixel
