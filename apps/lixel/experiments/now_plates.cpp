// SPDX-License-Identifier: MIT
#include "experiments/now_plates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lixel::app {
namespace {

constexpr double kDarkest = 0.2; // of what is there, against black for nothing

std::uint8_t levelOf(double share) { return std::uint8_t(std::lround(255 * std::clamp(share, 0.0, 1.0))); }

Rgba8 grey(double share)
{
    const std::uint8_t level = levelOf(kDarkest + (1 - kDarkest) * share);
    return {level, level, level, 255};
}

double offsetAt(const TextureWarp& warp, int column, int row)
{
    const auto knots = std::size_t(warp.columns) + 1;
    const std::size_t first =
        (warp.lines == WarpLines::Rectilinear ? 0 : std::size_t(row) * knots) + std::size_t(column);
    return 0.5 * (double(warp.rowKnots[first]) + double(warp.rowKnots[first + 1])) - (column + 0.5) / warp.columns;
}

} // namespace

std::vector<Vec2d> placesInSquare(const PlannedRegion& region, const ViewSamples& samples, const Light& light)
{
    const LightProjection projection = region.projection();
    const LixelRectangle& r = region.rectangle;
    const LixelRectangle& square = region.warp.isIdentity() ? r : region.warp.square;
    std::vector<Vec2d> places;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Vec3d p = toDouble(samples.positionLocal[i]);
        if (!isLightFacing(light, samples.originWorld, p, toDouble(samples.normal[i]))) continue;
        const auto ndc = projection.ndcAt(p);
        if (!ndc) continue;
        const Vec2d lixel{r.x0 + (0.5 + 0.5 * ndc->x) * r.width(), r.y0 + (0.5 + 0.5 * ndc->y) * r.height()};
        const Vec2d at{(lixel.x - square.x0) / square.width(), (lixel.y - square.y0) / square.height()};
        if (at.x >= 0 && at.y >= 0 && at.x < 1 && at.y < 1) places.push_back(at);
    }
    return places;
}

CountedPlate countedPlate(std::span<const Vec2d> places, int columns, int rows, const std::function<Vec2d(Vec2d)>& move)
{
    Image<std::uint32_t> counts(columns, rows, 0);
    for (const Vec2d& place : places) {
        const Vec2d at = move(place);
        ++counts(std::clamp(int(at.x * columns), 0, columns - 1), std::clamp(int(at.y * rows), 0, rows - 1));
    }
    const double most = std::max(1u, *std::max_element(counts.data().begin(), counts.data().end()));
    CountedPlate plate{Image<Rgba8>(columns, rows, {0, 0, 0, 255})};
    for (std::size_t i = 0; i < counts.data().size(); ++i) {
        const std::uint32_t count = counts.data()[i];
        if (count == 0) continue;
        plate.usedShare += 1.0 / double(counts.data().size());
        plate.picture.data()[i] = grey(most > 1 ? std::log(double(count)) / std::log(most) : 1);
    }
    return plate;
}

double mostOffset(const TextureWarp& warp)
{
    double most = 0;
    for (int row = 0; row < warp.rows; ++row)
        for (int column = 0; column < warp.columns; ++column)
            most = std::max(most, std::abs(offsetAt(warp, column, row)));
    return most;
}

Image<Rgba8> offsetsPlate(const TextureWarp& warp, double most)
{
    Image<Rgba8> picture(warp.columns, warp.rows, {0, 0, 0, 255});
    for (int row = 0; row < warp.rows; ++row)
        for (int column = 0; column < warp.columns; ++column) {
            const double offset = most > 0 ? offsetAt(warp, column, row) / most : 0;
            const std::uint8_t right = levelOf(offset), left = levelOf(-offset);
            picture(column, row) = {right, std::max(right, std::uint8_t(left / 3)), left, 255};
        }
    return picture;
}

Image<Rgba8> depthPlate(const Image<float>& layer, const LixelRectangle& r)
{
    float least = 1, most = 0;
    for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x)
            if (const float depth = layer(x, y); depth > 0)
                least = std::min(least, depth), most = std::max(most, depth);
    Image<Rgba8> picture(r.width(), r.height(), {0, 0, 0, 255});
    for (int y = 0; y < r.height(); ++y)
        for (int x = 0; x < r.width(); ++x)
            if (const float depth = layer(r.x0 + x, r.y0 + y); depth > 0)
                picture(x, y) = grey(most > least ? (depth - least) / (most - least) : 1);
    return picture;
}

} // namespace lixel::app
