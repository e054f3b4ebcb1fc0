// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// The view file: what a picture is taken of, apart from the scene. JSON, one object, every member optional:
//
//   camera  {"eye": [x, y, z], "target": [x, y, z], "up": [x, y, z], "fovy": degrees, "near": d, "far": d}
//           or, in place of fovy, "orthographic": height in world units
//   lights  [{"name": text, "position": [x, y, z]                                    a point light
//                         | "direction": [x, y, z]                                   the way sunlight travels
//                         | "position", "direction" and "angle": full cone, degrees  a spot
//                         , "range": distance for spot and point}], or one such object as "light"
//   planes  [{"name": text, "point": [x, y, z], "normal": [x, y, z], "polygon": [[x, y, z], ...]}]
//   time    seconds
//   path    [{"time": seconds, "eye": [x, y, z], "target": [x, y, z], "light": {"position" | "direction": [x, y, z]}}]
//           ascending in time, linear between keys; a key's light may be a bare [x, y, z]: of the kind the file's first
//           light has; either all keys have a light or none
namespace lixel {

struct ViewFile
{
    std::optional<Camera> camera;
    std::vector<Light> lights;
    std::vector<NamedPlane> planes;
    std::optional<double> time; // seconds
    std::vector<PathKey> path;
};

// Throw InputError: file, place as a JSON pointer, what was expected there. Unknown members are errors.
ViewFile readViewFile(const std::string& path);
ViewFile parseViewFile(std::string_view text, const std::string& name);

// What is wrong with a camera (eye at target, up along the line of sight, a field of view outside (0, 180) degrees,
// near >= far, numbers that are not finite or absurdly large); nothing when a picture can be taken with it.
std::optional<std::string> checkCamera(const Camera& camera);

// Likewise for a light: no direction, a cone outside (0, 180) degrees, no range.
std::optional<std::string> checkLight(const Light& light);

// The path at a time, held before its first and after its last key; directions are unit again. Needs a key.
PathKey keyAt(std::span<const PathKey> path, double time);

// `camera` with eye and target taken from the path, and `lights` with the first one's place or direction; a light
// without what the path gives becomes one that has it (a sun that is given a place becomes a point light).
Camera cameraAt(std::span<const PathKey> path, double time, const Camera& camera);
std::vector<Light> lightsAt(std::span<const PathKey> path, double time, std::vector<Light> lights);

} // namespace lixel
