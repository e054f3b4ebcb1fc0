// SPDX-License-Identifier: MIT
#include "lixel/report/false_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lixel {
namespace {

constexpr Rgba8 kTransparent{0, 0, 0, 0};

template <typename T, typename F>
Image<Rgba8> coloured(const Image<T>& values, F colourOf)
{
    Image<Rgba8> picture(values.width(), values.height());
    std::transform(values.data().begin(), values.data().end(), picture.data().begin(), colourOf);
    return picture;
}

// A table of 16 colours an octave fits in a palette, which makes small files of smooth pictures.
double inSteps(double value) { return value > 0 ? std::exp2(std::round(16 * std::log2(value)) / 16) : value; }

} // namespace

Rgba8 verdictColour(Verdict verdict)
{
    switch (verdict) {
    case Verdict::FalseShadow: return {235, 20, 40, 255};
    case Verdict::FalseLit: return {0, 150, 255, 255};
    case Verdict::NotCounted:
    case Verdict::Right: break;
    }
    return kTransparent;
}

Rgba8 densityColour(double lixelsPerPixel)
{
    if (std::isnan(lixelsPerPixel)) return kTransparent;

    // Dark red, red, orange, pale, light blue, blue, dark blue: lightness falls both ways from the pale middle, so that
    // the picture also reads without colours.
    constexpr std::array<Vec3d, 7> kStops{
        {{110, 8, 30}, {203, 45, 40}, {246, 150, 85}, {248, 244, 225}, {130, 190, 225}, {45, 115, 185}, {12, 45, 105}}};
    const double octaves =
        std::clamp(std::log2(std::max(lixelsPerPixel, 1e-300)), -double(kDensityOctaves), double(kDensityOctaves));
    const double stop = (octaves / kDensityOctaves + 1) / 2 * double(kStops.size() - 1);
    const std::size_t low = std::min(std::size_t(stop), kStops.size() - 2);
    const double t = stop - double(low);
    const Vec3d colour = (1 - t) * kStops[low] + t * kStops[low + 1];
    const auto byte = [](double value) { return std::uint8_t(std::lround(value)); };
    return {byte(colour.x), byte(colour.y), byte(colour.z), 255};
}

Rgba8 footprintColour(double pixelsPerLixel) { return densityColour(1 / pixelsPerLixel); }

Image<Rgba8> errorPicture(const Image<Verdict>& verdicts) { return coloured(verdicts, verdictColour); }

Image<Rgba8> densityPicture(const Image<float>& lixelsPerPixel)
{
    return coloured(lixelsPerPixel, [](float value) { return densityColour(inSteps(value)); });
}

Image<Rgba8> footprintPicture(const Image<float>& pixelsPerLixel)
{
    return coloured(pixelsPerLixel, [](float value) { return footprintColour(inSteps(value)); });
}

Image<Rgba8> boundaryPicture(const Observation& observed, std::size_t light)
{
    const ViewSamples& samples = observed.samples;
    Image<Rgba8> picture(samples.width, samples.height, kTransparent);
    if (light >= kObservedLights || observed.atBoundary.empty()) return picture;

    // Two thirds of a cell, so that neighbours stay apart.
    const double cell =
        std::min(double(samples.width) / observed.grid.width, double(samples.height) / observed.grid.height);
    const int side = std::max(1, int(std::lround(cell * 2 / 3)));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!(observed.atBoundary[i] >> light & 1u) || samples.atDepthJump[i]) continue;
        const int left = int(samples.pixel[i].x) - side / 2, bottom = int(samples.pixel[i].y) - side / 2;
        for (int y = bottom; y < bottom + side; ++y)
            for (int x = left; x < left + side; ++x)
                if (picture.contains(x, y)) picture(x, y) = kBoundaryColour;
    }
    return picture;
}

} // namespace lixel
