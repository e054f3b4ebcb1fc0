// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/point_list.h"

#include "lixel/base/assert.h"
#include "lixel/shared/gl_slots.h"

#include <algorithm>
#include <cstddef>

namespace lixel::gl {
namespace {

constexpr std::size_t kWorkGroup = 64;

static_assert(sizeof(shared::ViewPoint) == 32 && offsetof(shared::ViewPoint, pixel) == 12 &&
              offsetof(shared::ViewPoint, normal) == 16 && offsetof(shared::ViewPoint, triangle) == 28);

} // namespace

std::size_t entriesPerPart(const Device& device, std::size_t bytesEach)
{
    const auto bound = std::size_t(device.limits().storageBlockBytes) / bytesEach;
    const std::size_t dispatched = std::size_t(device.limits().workGroupsX) * kWorkGroup;
    const std::size_t most = std::min(bound, dispatched) / kWorkGroup * kWorkGroup;
    LX_ASSERT(most > 0);
    return most;
}

void PointList::resize(std::size_t size, int width, int height, Vec3d originWorld)
{
    size_ = size;
    width_ = width, height_ = height;
    originWorld_ = originWorld;
    entries_.reserve(size * sizeof(shared::ViewPoint));
}

void PointList::resizeToPixels(int width, int height, Vec3d originWorld)
{
    resize(std::size_t(width) * std::size_t(height), width, height, originWorld);
}

shared::ViewPoint PointList::entryOf(const ViewSamples& samples, std::size_t i) const
{
    const Vec3f& p = samples.positionLocal[i];
    const Vec3f& n = samples.normal[i];
    const int x = std::clamp(int(samples.pixel[i].x), 0, width_ - 1);
    const int y = std::clamp(int(samples.pixel[i].y), 0, height_ - 1);
    return {{p.x, p.y, p.z},
            std::uint32_t(y) * std::uint32_t(width_) + std::uint32_t(x),
            {n.x, n.y, n.z},
            samples.triangle[i]};
}

void PointList::upload(const ViewSamples& samples)
{
    resize(samples.size(), samples.width, samples.height, samples.originWorld);
    staging_.resize(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) staging_[i] = entryOf(samples, i);
    entries_.write(0, std::span<const shared::ViewPoint>(staging_));
}

void PointList::uploadToPixels(const ViewSamples& samples)
{
    resizeToPixels(samples.width, samples.height, samples.originWorld);
    staging_.assign(size_, {{}, shared::kNoPixel, {}, 0xffffffffu});
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const shared::ViewPoint entry = entryOf(samples, i);
        LX_ASSERT(staging_[entry.pixel].pixel == shared::kNoPixel);
        staging_[entry.pixel] = entry;
    }
    entries_.write(0, std::span<const shared::ViewPoint>(staging_));
}

ViewSamples PointList::download()
{
    staging_.resize(size_);
    entries_.read(0, std::span<shared::ViewPoint>(staging_));
    ViewSamples samples;
    samples.width = width_, samples.height = height_;
    samples.originWorld = originWorld_;
    for (const shared::ViewPoint& entry : staging_) {
        if (entry.pixel == shared::kNoPixel) continue;
        const auto width = std::uint32_t(width_);
        const std::uint32_t x = entry.pixel % width, y = entry.pixel / width;
        samples.pixel.push_back({float(x) + 0.5f, float(y) + 0.5f});
        samples.positionLocal.push_back({entry.positionLocal.x, entry.positionLocal.y, entry.positionLocal.z});
        samples.normal.push_back({entry.normal.x, entry.normal.y, entry.normal.z});
        samples.triangle.push_back(entry.triangle);
    }
    return samples;
}

std::vector<PointList::Part> PointList::parts(std::size_t bytesBeside) const
{
    const std::size_t most = entriesPerPart(*device_, std::max(sizeof(shared::ViewPoint), bytesBeside));
    std::vector<Part> parts;
    for (std::size_t first = 0; first < size_; first += most) parts.push_back({first, std::min(most, size_ - first)});
    return parts;
}

void PointList::bind(const Part& part) const
{
    constexpr std::size_t bytes = sizeof(shared::ViewPoint);
    entries_.bindStorage(shared::kStoragePoints, part.first * bytes, part.count * bytes);
}

} // namespace lixel::gl
