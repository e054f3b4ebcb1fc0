// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/evaluate.h"
#include "lixel/scene/load.h"
#include "lixel/scene/obj_materials.h"

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <string_view>

// Any bytes through the loaders and then through evaluation: what the fuzzer does with an input, and the tests with its corpus.
namespace lixel::test {

// The first bytes choose the loader.
inline Scene loadBytes(std::string_view bytes)
{
    if (bytes.starts_with("newmtl")) {
        Scene scene;
        obj::Materials materials;
        obj::readMtl(bytes, "bytes.mtl", "", scene, materials);
        return scene;
    }
    if (bytes.starts_with("glTF") || bytes.starts_with("{"))
        return loadGltf(std::as_bytes(std::span(bytes)), "bytes.gltf", "");
    return loadObj(bytes, "bytes.obj", "");
}

// What is wrong with a scene's buffers; nothing, when every float is finite and every index within its range.
inline std::string wrongWhenEvaluated(const std::shared_ptr<const Scene>& scene, EvaluateOptions options)
{
    const Box box = sceneBounds(*scene, options);
    const Vec3d origin = box.isEmpty() ? Vec3d{} : chooseOrigin(box.centre(), box);
    const SceneBuffers buffers = evaluate(scene, options, origin);
    for (const Vec3f& p : buffers.triangles.positionLocal)
        if (!isFinite(toDouble(p))) return "a position is not finite";
    for (const Vec3f& n : buffers.triangles.normal)
        if (!isFinite(toDouble(n))) return "a normal is not finite";
    for (const std::uint32_t i : buffers.triangles.indices)
        if (i >= buffers.triangles.positionLocal.size()) return "an index is past the vertices";
    for (const std::uint32_t m : buffers.triangles.material)
        if (m >= scene->materials.size()) return "a material is not there";
    return "";
}

// As it stands, and at some times of its first animations. Throws InputError where the bytes are refused.
inline std::string wrongWhenLoaded(std::string_view bytes)
{
    const auto scene = std::make_shared<const Scene>(loadBytes(bytes));
    std::string wrong = wrongWhenEvaluated(scene, {});
    for (int animation = 0; animation < int(scene->animations.size()) && animation < 3; ++animation)
        for (const double time : {0.25, 1.0, 1e6})
            if (wrong.empty()) wrong = wrongWhenEvaluated(scene, {time, animation});
    return wrong;
}

} // namespace lixel::test
