// SPDX-License-Identifier: MIT
#include "lixel/scene/gltf_materials.h"

#include "lixel/scene/image_decode.h"
#include "lixel/scene/input_file.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace lixel::gltf {
namespace {

Wrap readWrap(const JsonAt& sampler, const char* key)
{
    const auto wrap = sampler.find(key);
    if (!wrap) return Wrap::Repeat;
    switch (wrap->integer(0, 65535)) {
    case 10497: return Wrap::Repeat;
    case 33648: return Wrap::MirroredRepeat;
    case 33071: return Wrap::ClampToEdge;
    default: wrap->refuse("expected 10497 (repeat), 33648 (mirrored repeat) or 33071 (clamp to edge)");
    }
}

// Decodes each image once for each way it is wrapped.
class Textures
{
public:
    Textures(File& file, Scene& scene) : file_(file), scene_(scene) {}

    // The index into Scene::textures of what a textureInfo names.
    int at(const JsonAt& textureInfo)
    {
        const JsonAt texture =
            file_.element("textures", textureInfo.require("index").index(file_.count("textures"), "textures"));
        const auto source = texture.find("source");
        if (!source) texture.refuse("expected a 'source': images in other formats (KTX2, WebP) are not supported");
        const int image = source->index(file_.count("images"), "images");
        Wrap wrapU = Wrap::Repeat, wrapV = Wrap::Repeat;
        if (const int s = texture.indexOr("sampler", file_.count("samplers"), "samplers"); s >= 0) {
            const JsonAt sampler = file_.element("samplers", s);
            wrapU = readWrap(sampler, "wrapS"), wrapV = readWrap(sampler, "wrapT");
        }
        const auto [known, isNew] = known_.try_emplace({image, wrapU, wrapV}, int(scene_.textures.size()));
        if (isNew) scene_.textures.push_back({decode(image), wrapU, wrapV});
        return known->second;
    }

private:
    Image<Rgba8> decode(int i)
    {
        // glTF has v = 0 at the first row of the file, and so has Texture.
        const JsonAt image = file_.element("images", i);
        std::vector<std::byte> own;
        std::span<const std::byte> bytes;
        if (const auto uri = image.find("uri")) {
            own = file_.readImage(*uri);
            bytes = own;
        } else {
            const int view = image.require("bufferView").index(file_.count("bufferViews"), "bufferViews");
            bytes = file_.bytes(view, 0, file_.view(view).size);
        }
        Image<Rgba8> pixels = decodeImage(bytes, RowOrder::FileFirst, file_.name(), image.place());
        file_.spend(pixels.data().size() * sizeof(Rgba8), image);
        return pixels;
    }

    File& file_;
    Scene& scene_;
    std::map<std::tuple<int, Wrap, Wrap>, int> known_;
};

// KHR_texture_transform: translation * rotation * scale, the rotation counter-clockwise as the picture is seen.
UvSource readUvSource(const JsonAt& textureInfo)
{
    UvSource source;
    source.set = int(textureInfo.integerOr("texCoord", 0, 0, 31));
    const auto extensions = textureInfo.find("extensions");
    const auto transform = extensions ? extensions->find("KHR_texture_transform") : std::nullopt;
    if (!transform) return source;
    source.isIdentity = false;
    source.set = int(transform->integerOr("texCoord", std::size_t(source.set), 0, 31));
    const auto pair = [&](const char* key, std::array<double, 2> standard) {
        const auto member = transform->find(key);
        return member ? member->numbers<2>() : standard;
    };
    const auto [offsetU, offsetV] = pair("offset", {0, 0});
    const auto [scaleU, scaleV] = pair("scale", {1, 1});
    const double angle = transform->numberOr("rotation", 0);
    source.offset = {offsetU, offsetV};
    source.rowU = {std::cos(angle) * scaleU, std::sin(angle) * scaleV};
    source.rowV = {-std::sin(angle) * scaleU, std::cos(angle) * scaleV};
    return source;
}

double linearFromSrgb(double value)
{
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

Vec3d meanLinear(const Image<Rgba8>& pixels)
{
    std::array<double, 256> linear;
    for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = linearFromSrgb(double(i) / 255);
    Vec3d sum;
    for (const Rgba8& p : pixels.data()) sum = sum + Vec3d{linear[p.r], linear[p.g], linear[p.b]};
    return sum / double(pixels.data().size());
}

Vec3f readEmission(const JsonAt& material, Textures& textures, const Scene& scene)
{
    const auto factor = material.find("emissiveFactor");
    if (!factor) return {};
    const auto [r, g, b] = factor->numbers<3>();
    Vec3d emission{r, g, b};
    if (emission == Vec3d{}) return {};
    if (const auto extensions = material.find("extensions"))
        if (const auto strength = extensions->find("KHR_materials_emissive_strength"))
            emission = strength->numberOr("emissiveStrength", 1, 0) * emission;
    if (const auto texture = material.find("emissiveTexture")) {
        const Vec3d mean = meanLinear(scene.textures[std::size_t(textures.at(*texture))].pixels);
        emission = {emission.x * mean.x, emission.y * mean.y, emission.z * mean.z};
    }
    return toFloat(emission);
}

void readAlpha(const JsonAt& source, Material& material)
{
    const std::string mode = source.textOr("alphaMode", "OPAQUE");
    if (mode == "OPAQUE") return;
    material.alphaMode = AlphaMode::Mask;
    if (mode == "MASK") material.alphaCutoff = float(source.numberOr("alphaCutoff", 0.5, 0));
    else if (mode != "BLEND")
        source.require("alphaMode").refuse(fmt::format("expected OPAQUE, MASK or BLEND, found '{}'", printable(mode)));
}

} // namespace

std::vector<UvSource> readMaterials(File& file, Scene& scene)
{
    Textures textures(file, scene);
    std::vector<UvSource> uvSources;
    for (std::size_t i = 0; i < file.count("materials"); ++i) {
        const JsonAt source = file.element("materials", int(i));
        Material material;
        material.baseColour = {1, 1, 1, 1};
        UvSource uvSource;
        if (const auto pbr = source.find("pbrMetallicRoughness")) {
            if (const auto factor = pbr->find("baseColorFactor")) {
                const auto [r, g, b, a] = factor->numbers<4>();
                material.baseColour = {float(r), float(g), float(b), float(a)};
            }
            if (const auto texture = pbr->find("baseColorTexture")) {
                material.texture = textures.at(*texture);
                uvSource = readUvSource(*texture);
            }
        }
        readAlpha(source, material);
        const auto doubleSided = source.find("doubleSided");
        material.doubleSided = doubleSided && doubleSided->boolean();
        material.emission = readEmission(source, textures, scene);
        scene.materials.push_back(material);
        uvSources.push_back(uvSource);
    }
    Material standard;
    standard.baseColour = {1, 1, 1, 1};
    scene.materials.push_back(standard);
    uvSources.emplace_back();
    return uvSources;
}

} // namespace lixel::gltf
