// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/textures.h"

#include "lixel/scene/builtin/dice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lixel::builtin {

namespace {

constexpr int kSize = 256;
constexpr double kPi = std::numbers::pi;

std::uint8_t byte(double value) { return std::uint8_t(std::lround(std::clamp(value, 0.0, 255.0))); }

Rgba8 scaled(std::uint32_t srgb, double factor)
{
    return {byte(factor * double(srgb >> 16 & 0xff)), byte(factor * double(srgb >> 8 & 0xff)),
            byte(factor * double(srgb & 0xff)), 255};
}

// Fills a texture from a rule on texel centres, (u, v) in (0, 1).
template <typename Rule>
Texture made(Rule rule)
{
    Texture texture;
    texture.pixels = Image<Rgba8>(kSize, kSize);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) texture.pixels(x, y) = rule((x + 0.5) / kSize, (y + 0.5) / kSize);
    return texture;
}

// A factor near 1 for each of a number of pieces.
std::vector<double> shades(int count, double spread, std::uint64_t seed)
{
    Dice dice(seed);
    std::vector<double> factors;
    for (int i = 0; i < count; ++i) factors.push_back(dice.uniform(1 - spread, 1 + spread));
    return factors;
}

double fraction(double x) { return x - std::floor(x); }

// Smooth noise in [-1, 1] that repeats after one unit: a few waves of whole frequencies.
class Waves
{
public:
    Waves(int count, int highest, std::uint64_t seed)
    {
        Dice dice(seed);
        for (int i = 0; i < count; ++i)
            waves_.push_back(
                {double(dice.integer(-highest, highest)), double(dice.integer(1, highest)), dice.uniform(0, 2 * kPi)});
    }
    double operator()(double u, double v) const
    {
        double sum = 0;
        for (const Wave& w : waves_) sum += std::sin(2 * kPi * (w.u * u + w.v * v) + w.phase);
        return sum / double(waves_.size());
    }

private:
    struct Wave
    {
        double u, v, phase;
    };
    std::vector<Wave> waves_;
};

} // namespace

Texture checker(std::uint32_t first, std::uint32_t second, int squares)
{
    return made([=](double u, double v) {
        const bool even = (int(u * squares) + int(v * squares)) % 2 == 0;
        return scaled(even ? first : second, 1);
    });
}

Texture tiles(std::uint32_t tile, std::uint32_t joint, int tilesPerSide)
{
    const std::vector<double> shade = shades(tilesPerSide * tilesPerSide, 0.07, 1);
    return made([&](double u, double v) {
        const double x = u * tilesPerSide, y = v * tilesPerSide;
        const double toEdge = std::min({fraction(x), 1 - fraction(x), fraction(y), 1 - fraction(y)});
        if (toEdge < 0.02) return scaled(joint, 1);
        return scaled(tile, shade[std::size_t(int(y) * tilesPerSide + int(x))]);
    });
}

Texture planks(std::uint32_t wood, std::uint32_t joint, int planksPerSide)
{
    const std::vector<double> shade = shades(2 * planksPerSide, 0.1, 2), shift = shades(planksPerSide, 0.5, 3);
    const Waves grain(9, 9, 4);
    return made([&](double u, double v) {
        // Each row of planks has one butt joint a repeat, at its own place.
        const double y = v * planksPerSide, along = fraction(u + shift[std::size_t(y)]);
        const std::size_t plank = 2 * std::size_t(y) + (along < 0.5 ? 0 : 1);
        const double toJoint = std::min({fraction(y) * 2, (1 - fraction(y)) * 2, along * 12, (1 - along) * 12});
        if (toJoint < 0.05) return scaled(joint, 1);
        const double lines = grain(u, std::round(y * 5) / (5 * planksPerSide) * 7);
        return scaled(wood, shade[plank] * (1 + 0.06 * lines));
    });
}

Texture bricks(std::uint32_t brick, std::uint32_t mortar, int courses)
{
    const int perCourse = std::max(1, courses / 2);
    const std::vector<double> shade = shades(perCourse * courses, 0.12, 5);
    return made([&](double u, double v) {
        const double y = v * courses, x = fraction(u + (int(y) % 2 == 0 ? 0 : 0.5 / perCourse)) * perCourse;
        const double toJoint = std::min({2 * fraction(x), 2 * (1 - fraction(x)), fraction(y), 1 - fraction(y)});
        if (toJoint < 0.06) return scaled(mortar, 1);
        return scaled(brick, shade[std::size_t(int(y) * perCourse + int(x))]);
    });
}

Texture stripes(std::uint32_t first, std::uint32_t second, int pairs)
{
    return made([=](double u, double) { return scaled(fraction(u * pairs) < 0.5 ? first : second, 1); });
}

Texture facade(std::uint32_t wall, std::uint32_t window, int windowsPerSide)
{
    const std::vector<double> shade = shades(windowsPerSide * windowsPerSide, 0.25, 6);
    return made([&](double u, double v) {
        const double x = u * windowsPerSide, y = v * windowsPerSide;
        const bool inside = std::abs(fraction(x) - 0.5) < 0.28 && std::abs(fraction(y) - 0.52) < 0.3;
        if (!inside) return scaled(wall, fraction(y) < 0.06 ? 0.88 : 1);
        return scaled(window, shade[std::size_t(int(y) * windowsPerSide + int(x))]);
    });
}

Texture plaster(std::uint32_t colour, double unevenness)
{
    const Waves blotches(24, 12, 7);
    return made([&](double u, double v) { return scaled(colour, 1 + unevenness * blotches(u, v)); });
}

Texture chainLink(std::uint32_t wire, int meshesPerSide, double wireWidth)
{
    return made([=](double u, double v) {
        // Two families of wires at right angles; the distance to the nearest of each, in meshes.
        const double a = fraction((u + v) * meshesPerSide), b = fraction((u - v) * meshesPerSide + meshesPerSide);
        const double toWire = std::min({a, 1 - a, b, 1 - b});
        Rgba8 texel = scaled(wire, 0.8 + 0.4 * (a < b ? a : b));
        texel.a = toWire < 0.5 * wireWidth ? 255 : 0;
        return texel;
    });
}

Texture leaf(std::uint32_t blade, std::uint32_t vein)
{
    return made([=](double u, double v) {
        const double across = std::abs(u - 0.5), half = 0.42 * std::pow(std::sin(kPi * std::pow(v, 0.8)), 0.8);
        const bool onVein = across < 0.02 || std::abs(fraction(8 * (v - 0.7 * across)) - 0.5) < 0.06;
        Rgba8 texel = scaled(onVein ? vein : blade, 1);
        texel.a = across < half || (across < 0.02 && v < 0.1) ? 255 : 0;
        return texel;
    });
}

} // namespace lixel::builtin
