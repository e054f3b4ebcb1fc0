// SPDX-License-Identifier: MIT
#include "lixel/trace/texture_lookup.h"

#include "lixel/shared/alpha.h"

#include <array>
#include <cmath>

namespace lixel {
namespace {

static_assert(int(Wrap::Repeat) == shared::kWrapRepeat);
static_assert(int(Wrap::MirroredRepeat) == shared::kWrapMirroredRepeat);
static_assert(int(Wrap::ClampToEdge) == shared::kWrapClampToEdge);

// Along one axis: two texels and the weight of the second.
struct TexelPair
{
    int below = 0, above = 0;
    float blend = 0;

    TexelPair(float coordinate, int size, Wrap wrap)
    {
        const float folded = shared::foldCoordinate(coordinate, int(wrap));
        const int first = shared::texelBelow(folded, size);
        below = shared::wrapTexel(first, size, int(wrap));
        above = shared::wrapTexel(first + 1, size, int(wrap));
        blend = shared::texelBlend(folded, size);
    }
};

template <typename Value>
float blendedAt(const Texture& texture, const TexelPair& x, const TexelPair& y, Value value)
{
    const Image<Rgba8>& p = texture.pixels;
    return shared::bilinear(value(p(x.below, y.below)), value(p(x.above, y.below)), value(p(x.below, y.above)),
                            value(p(x.above, y.above)), x.blend, y.blend);
}

std::array<float, 256> srgbTable()
{
    std::array<float, 256> table{};
    for (std::size_t code = 0; code < table.size(); ++code) {
        const double encoded = double(code) / 255;
        table[code] = float(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
    }
    return table;
}

} // namespace

float alphaOf(const Texture& texture, Vec2f uv)
{
    const TexelPair x(uv.x, texture.pixels.width(), texture.wrapU), y(uv.y, texture.pixels.height(), texture.wrapV);
    return blendedAt(texture, x, y, [](Rgba8 texel) { return float(texel.a) / 255.0f; });
}

float linearFromSrgb(std::uint8_t code)
{
    static const std::array<float, 256> table = srgbTable();
    return table[code];
}

Vec3f linearColourOf(const Texture& texture, Vec2f uv)
{
    const TexelPair x(uv.x, texture.pixels.width(), texture.wrapU), y(uv.y, texture.pixels.height(), texture.wrapV);
    return {blendedAt(texture, x, y, [](Rgba8 texel) { return linearFromSrgb(texel.r); }),
            blendedAt(texture, x, y, [](Rgba8 texel) { return linearFromSrgb(texel.g); }),
            blendedAt(texture, x, y, [](Rgba8 texel) { return linearFromSrgb(texel.b); })};
}

} // namespace lixel
