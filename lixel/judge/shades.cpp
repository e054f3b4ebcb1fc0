// SPDX-License-Identifier: MIT
#include "lixel/judge/shades.h"

#include "lixel/base/assert.h"
#include "lixel/base/image.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_set>

namespace lixel {
namespace {

constexpr double kApart = 1e-5; // of two shades
constexpr float kBegins = 0.05f, kEnds = 0.95f;

// Lit 1, dark 0, neither -1, of the first sample of each pixel.
Image<std::int8_t> exactPicture(const ViewSamples& samples, std::span<const Zone> zones, std::span<const float> exact)
{
    Image<std::int8_t> picture(samples.width, samples.height, -2);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const int x = int(std::floor(samples.pixel[i].x)), y = int(std::floor(samples.pixel[i].y));
        if (!picture.contains(x, y) || picture(x, y) != -2) continue;
        picture(x, y) = std::int8_t(zones[i] == Zone::FacingAway ? -1 : exact[i] >= 0.5f ? 1 : 0);
    }
    return picture;
}

// A line of length l crosses 4 l / pi borders of pixels in the mean over its directions.
double boundaryLength(const Image<std::int8_t>& picture)
{
    std::int64_t crossings = 0;
    const auto differ = [](int a, int b) { return a >= 0 && b >= 0 && a != b; };
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            crossings += x + 1 < picture.width() && differ(picture(x, y), picture(x + 1, y));
            crossings += y + 1 < picture.height() && differ(picture(x, y), picture(x, y + 1));
        }
    return std::numbers::pi / 4 * double(crossings);
}

} // namespace

double ShadeError::rootMeanSquare() const { return samples > 0 ? std::sqrt(sumOfSquares / double(samples)) : 0; }

ShadeError shadeError(std::span<const float> visibility, std::span<const float> truth)
{
    LX_ASSERT(visibility.size() == truth.size());
    ShadeError error;
    error.samples = std::int64_t(truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double off = std::abs(double(visibility[i]) - double(truth[i]));
        error.sumOfSquares += off * off;
        error.largest = std::max(error.largest, off);
    }
    return error;
}

Shades shadesOf(const ViewSamples& samples, std::span<const Zone> zones, std::span<const float> visibility,
                std::span<const float> exactVisibility)
{
    LX_ASSERT(zones.size() == samples.size() && visibility.size() == samples.size());
    LX_ASSERT(exactVisibility.size() == samples.size());
    Shades out;
    std::unordered_set<std::int64_t> shades;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (zones[i] == Zone::FacingAway) continue;
        shades.insert(std::llround(double(visibility[i]) / kApart));
        out.inTransition += visibility[i] > kBegins && visibility[i] < kEnds;
        if (zones[i] != Zone::Interior || exactVisibility[i] >= 0.5f) continue;
        ++out.darkInterior;
        out.lightInDarkInterior += double(visibility[i]);
        out.litDarkInterior += visibility[i] >= 0.5f;
    }
    out.distinct = std::int64_t(shades.size());
    out.boundaryPixels = boundaryLength(exactPicture(samples, zones, exactVisibility));
    return out;
}

} // namespace lixel
