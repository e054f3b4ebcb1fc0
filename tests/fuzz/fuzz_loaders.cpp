// SPDX-License-Identifier: MIT
// Any bytes through the loaders and then through evaluation: a scene or an InputError, whose floats are finite.
#include "lixel/scene/evaluate.h"
#include "lixel/scene/load.h"
#include "lixel/scene/obj_materials.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace {

using namespace lixel;

Scene load(std::string_view text)
{
    if (text.starts_with("newmtl")) {
        Scene scene;
        obj::Materials materials;
        obj::readMtl(text, "fuzz.mtl", "", scene, materials);
        return scene;
    }
    if (text.starts_with("glTF") || text.starts_with("{"))
        return loadGltf(std::as_bytes(std::span(text)), "fuzz.gltf", "");
    return loadObj(text, "fuzz.obj", "");
}

void evaluateAt(const std::shared_ptr<const Scene>& scene, EvaluateOptions options)
{
    const Box box = sceneBounds(*scene, options);
    const Vec3d origin = box.isEmpty() ? Vec3d{} : chooseOrigin(box.centre(), box);
    const SceneBuffers buffers = evaluate(scene, options, origin);
    for (const Vec3f& p : buffers.triangles.positionLocal) LX_ASSERT(isFinite(toDouble(p)));
    for (const Vec3f& n : buffers.triangles.normal) LX_ASSERT(isFinite(toDouble(n)));
    for (const std::uint32_t i : buffers.triangles.indices) LX_ASSERT(i < buffers.triangles.positionLocal.size());
    for (const std::uint32_t m : buffers.triangles.material) LX_ASSERT(m < scene->materials.size());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        const auto scene = std::make_shared<const Scene>(load({reinterpret_cast<const char*>(data), size}));
        evaluateAt(scene, {});
        for (int animation = 0; animation < int(scene->animations.size()) && animation < 3; ++animation)
            for (const double time : {0.25, 1.0, 1e6}) evaluateAt(scene, {time, animation});
    } catch (const InputError&) {
    }
    return 0;
}
