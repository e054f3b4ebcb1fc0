// SPDX-License-Identifier: MIT
#include "lixel/plan/observe.h"

#include "lixel/base/assert.h"
#include "lixel/plan/shading_light.h"

#include <algorithm>
#include <vector>

namespace lixel {
namespace {

shared::vec3 toShared(Vec3f v) { return {v.x, v.y, v.z}; }

// The sample of every pixel, -1 where there is none.
std::vector<std::int64_t> sampleOfPixel(const ViewSamples& picture)
{
    std::vector<std::int64_t> sampleOf(std::size_t(picture.width) * std::size_t(picture.height), -1);
    for (std::size_t i = picture.size(); i-- > 0;) {
        const int x = std::clamp(int(picture.pixel[i].x), 0, picture.width - 1);
        const int y = std::clamp(int(picture.pixel[i].y), 0, picture.height - 1);
        sampleOf[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)] = std::int64_t(i);
    }
    return sampleOf;
}

struct LookedUp
{
    std::vector<shared::ShadingLight> lights;
    std::span<const Visibility> visibility;

    void addBits(std::size_t sample, shared::ObservedPoint& cell) const
    {
        for (std::size_t light = 0; light < lights.size(); ++light) {
            if (!shared::lxFaces(lights[light], cell.point.positionLocal, cell.point.normal)) continue;
            const std::vector<float>& value = visibility[light].value;
            const std::uint32_t bit = 1u << light;
            cell.facing |= bit;
            if (value.empty() || shared::lxIsLit(value[sample])) cell.lit |= bit;
        }
    }
};

// A pair of cells beside each other marks both.
void markPair(shared::ObservedPoint& a, shared::ObservedPoint& b)
{
    const bool isA = a.point.pixel != shared::kNoPixel, isB = b.point.pixel != shared::kNoPixel;
    if (!isA && !isB) return;
    if (!isA || !isB ||
        shared::lxIsDepthJump(a.point.positionLocal, a.point.normal, b.point.positionLocal, b.point.normal)) {
        a.atDepthJump = b.atDepthJump = 1;
        return;
    }
    const std::uint32_t differing = (a.lit ^ b.lit) & a.facing & b.facing;
    a.atBoundary |= differing;
    b.atBoundary |= differing;
}

void markNeighbours(std::span<shared::ObservedPoint> cells, ObservationGrid grid)
{
    const auto width = std::size_t(grid.width), height = std::size_t(grid.height);
    for (std::size_t row = 0; row < height; ++row)
        for (std::size_t column = 0; column < width; ++column) {
            const std::size_t at = row * width + column;
            if (column + 1 < width) markPair(cells[at], cells[at + 1]);
            if (row + 1 < height) markPair(cells[at], cells[at + width]);
        }
}

} // namespace

ObservationGrid gridWithin(ObservationGrid grid, const View& view)
{
    LX_ASSERT(grid.width > 0 && grid.height > 0);
    return {std::min(grid.width, view.width), std::min(grid.height, view.height)};
}

Observation observe(const ViewSamples& picture, const View& view, std::span<const Light> lights,
                    std::span<const Visibility> visibility, ObservationGrid grid)
{
    LX_ASSERT(picture.width == view.width && picture.height == view.height);
    LX_ASSERT(visibility.empty() || visibility.size() == lights.size());
    LookedUp lookedUp{{}, visibility};
    for (std::size_t i = 0; i < std::min(visibility.size(), kObservedLights); ++i)
        lookedUp.lights.push_back(shadingLight(lights[i], picture.originWorld));
    const ObservedFrame frame{view, picture.originWorld, gridWithin(grid, view), !visibility.empty()};

    const std::vector<std::int64_t> sampleOf = sampleOfPixel(picture);
    std::vector<shared::ObservedPoint> cells;
    for (int row = 0; row < frame.grid.height; ++row)
        for (int column = 0; column < frame.grid.width; ++column) {
            const int x = shared::lxPixelOfCell(column, frame.grid.width, view.width);
            const int y = shared::lxPixelOfCell(row, frame.grid.height, view.height);
            const auto pixel = std::uint32_t(y) * std::uint32_t(view.width) + std::uint32_t(x);
            shared::ObservedPoint& cell = cells.emplace_back();
            cell.point.pixel = shared::kNoPixel;
            if (sampleOf[pixel] < 0) continue;
            const auto i = std::size_t(sampleOf[pixel]);
            cell.point = {toShared(picture.positionLocal[i]), pixel, toShared(picture.normal[i]), picture.triangle[i]};
            lookedUp.addBits(i, cell);
        }
    markNeighbours(cells, frame.grid);
    Observation out;
    listCells(cells, frame, out);
    return out;
}

void listCells(std::span<const shared::ObservedPoint> cells, const ObservedFrame& frame, Observation& out)
{
    LX_ASSERT(cells.size() == std::size_t(frame.grid.width) * std::size_t(frame.grid.height));
    ViewSamples& samples = out.samples;
    samples.width = frame.view.width, samples.height = frame.view.height;
    samples.originWorld = frame.originWorld;
    samples.pixel.clear(), samples.positionLocal.clear(), samples.normal.clear(), samples.triangle.clear();
    samples.weight.clear(), samples.atDepthJump.clear();
    out.lit.clear(), out.atBoundary.clear();
    out.view = frame.view;
    out.grid = frame.grid;
    const auto width = std::uint32_t(frame.view.width);
    const float weight = float(frame.view.width) * float(frame.view.height) / float(cells.size());
    for (const shared::ObservedPoint& cell : cells) {
        const shared::ViewPoint& point = cell.point;
        if (point.pixel == shared::kNoPixel) continue;
        const std::uint32_t column = point.pixel % width, row = point.pixel / width;
        samples.pixel.push_back({float(column) + 0.5f, float(row) + 0.5f});
        samples.positionLocal.push_back({point.positionLocal.x, point.positionLocal.y, point.positionLocal.z});
        samples.normal.push_back({point.normal.x, point.normal.y, point.normal.z});
        samples.triangle.push_back(point.triangle);
        samples.weight.push_back(weight);
        samples.atDepthJump.push_back(std::uint8_t(cell.atDepthJump));
        if (!frame.hasLights) continue;
        out.lit.push_back(cell.lit);
        out.atBoundary.push_back(cell.atBoundary);
    }
}

} // namespace lixel
