// SPDX-License-Identifier: MIT
#include "lixel/scene/obj_materials.h"

#include "lixel/scene/image_decode.h"
#include "lixel/scene/input_file.h"
#include "lixel/scene/load.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace lixel::obj {
namespace {

// Colours and factors as a picture can use them.
float factor(float value) { return std::isfinite(value) ? std::clamp(value, 0.0f, 1e6f) : 0.0f; }

class Maps
{
public:
    Maps(const std::string& file, const std::string& baseDirectory, Scene& scene)
        : file_(file), baseDirectory_(baseDirectory), scene_(scene)
    {
    }

    // The index into Scene::textures of a material's colour and alpha maps together, -1 where it has none.
    int texture(const tinyobj::material_t& material)
    {
        const std::string key =
            fmt::format("{}\n{}\n{}", material.diffuse_texname, material.alpha_texname, material.diffuse_texopt.clamp);
        const auto known = known_.find(key);
        if (known != known_.end()) return known->second;
        std::optional<Image<Rgba8>> colour = image(material.diffuse_texname), alpha = image(material.alpha_texname);
        if (!colour && alpha) colour = Image<Rgba8>(alpha->width(), alpha->height());
        int index = -1;
        if (colour) {
            setAlpha(*colour, alpha);
            const Wrap wrap = material.diffuse_texopt.clamp ? Wrap::ClampToEdge : Wrap::Repeat;
            index = int(scene_.textures.size());
            scene_.textures.push_back({*std::move(colour), wrap, wrap});
        }
        return known_[key] = index;
    }

private:
    std::optional<Image<Rgba8>> image(std::string name)
    {
        if (name.empty()) return std::nullopt;
        std::replace(name.begin(), name.end(), '\\', '/');
        try {
            // vt = 0 is the last row of the file, and row 0 of Texture.
            InputBytes bytes = openNeighbour(baseDirectory_, name, file_, "map");
            const std::string shown = printable(name);
            return decodeImage(readImageBytes(bytes, file_, shown), RowOrder::FileLast, file_, shown);
        } catch (const InputError& problem) {
            scene_.warnings.push_back(fmt::format("{}; left out", problem.what()));
            return std::nullopt;
        }
    }

    // An alpha map is read from its alpha where it has one, else from its brightness, at the colour map's texels.
    static void setAlpha(Image<Rgba8>& colour, const std::optional<Image<Rgba8>>& alpha)
    {
        if (!alpha) {
            for (Rgba8& p : colour.data()) p.a = 255;
            return;
        }
        const bool hasAlpha =
            std::any_of(alpha->data().begin(), alpha->data().end(), [](Rgba8 p) { return p.a < 255; });
        for (int y = 0; y < colour.height(); ++y)
            for (int x = 0; x < colour.width(); ++x) {
                const Rgba8 from = (*alpha)(x * alpha->width() / colour.width(), y * alpha->height() / colour.height());
                colour(x, y).a = hasAlpha ? from.a : from.g;
            }
    }

    const std::string& file_;
    const std::string& baseDirectory_;
    Scene& scene_;
    std::map<std::string, int> known_;
};

UvTransform uvTransform(const tinyobj::texture_option_t& options)
{
    const UvTransform uv{{double(options.scale[0]), double(options.scale[1])},
                         {double(options.origin_offset[0]), double(options.origin_offset[1])}};
    const double sum = std::abs(uv.scale.x) + std::abs(uv.scale.y) + std::abs(uv.offset.x) + std::abs(uv.offset.y);
    return sum < 1e6 ? uv : UvTransform{};
}

} // namespace

void readMtl(std::string_view text, const std::string& file, const std::string& baseDirectory, Scene& scene,
             Materials& materials)
{
    std::map<std::string, int> indexByName;
    std::vector<tinyobj::material_t> parsed;
    std::string warning, error;
    std::istringstream stream{std::string(text)};
    tinyobj::LoadMtl(&indexByName, &parsed, &stream, &warning, &error);

    Maps maps(file, baseDirectory, scene);
    for (const auto& [name, index] : indexByName) {
        const tinyobj::material_t& source = parsed.at(std::size_t(index));
        Material material;
        material.texture = maps.texture(source);
        const float alpha = std::min(factor(source.dissolve), 1.0f);
        material.baseColour = {factor(source.diffuse[0]), factor(source.diffuse[1]), factor(source.diffuse[2]), alpha};
        material.emission = {factor(source.emission[0]), factor(source.emission[1]), factor(source.emission[2])};
        if (alpha < 1 || !source.alpha_texname.empty()) material.alphaMode = AlphaMode::Mask;
        materials.byName[name] = int(scene.materials.size());
        materials.uv.push_back(uvTransform(source.diffuse_texopt));
        scene.materials.push_back(material);
    }
}

} // namespace lixel::obj
