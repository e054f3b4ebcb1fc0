// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view_samples.h"
#include "lixel/gl/device/device.h"
#include "lixel/gl/device/objects.h"
#include "lixel/shared/view_tables.h"

#include <cstdint>
#include <vector>

namespace lixel::gl {

// View samples on the device: shared::ViewPoint entries, either one a pixel, row by row from the bottom, with a mark where
// nothing is seen (what the gather pass makes), or any list (what a caller uploads). Shaders see it in parts that fit one
// binding and one dispatch.
class PointList
{
public:
    // Entries [first, first + count).
    struct Part
    {
        std::size_t first = 0, count = 0;
    };

    explicit PointList(const Device& device) : device_(&device) {}

    // Room for one entry a pixel; the entries are for a pass to write.
    void resizeToPixels(int width, int height, Vec3d originWorld);

    // One entry a sample. Of `pixel` only the whole part arrives; weights and marks stay with the caller.
    void upload(const ViewSamples& samples);

    // One entry a pixel: the sample at its centre, or the mark where there is none. No pixel has two.
    void uploadToPixels(const ViewSamples& samples);

    // Waits for the device. Entries without surface are left out; samples stand at pixel centres.
    ViewSamples download();

    // Parts for passes that also bind `bytesBeside` for each entry.
    std::vector<Part> parts(std::size_t bytesBeside = 0) const;
    void bind(const Part& part) const; // to kStoragePoints

    std::size_t size() const { return size_; }
    int width() const { return width_; }
    int height() const { return height_; }
    Vec3d originWorld() const { return originWorld_; }

private:
    void resize(std::size_t size, int width, int height, Vec3d originWorld);
    shared::ViewPoint entryOf(const ViewSamples& samples, std::size_t i) const;

    const Device* device_;
    Buffer entries_;
    std::size_t size_ = 0;
    int width_ = 0, height_ = 0;
    Vec3d originWorld_;
    std::vector<shared::ViewPoint> staging_; // kept, so that frames allocate nothing
};

// Entries of `bytesEach` that one binding and one dispatch of workgroups of 64 take, a multiple of 64.
std::size_t entriesPerPart(const Device& device, std::size_t bytesEach);

} // namespace lixel::gl
