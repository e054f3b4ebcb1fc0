// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/gl/device/device.h"
#include "lixel/gl/device/objects.h"
#include "lixel/plan/shadow_plan.h"

#include <cstddef>
#include <vector>

namespace lixel::gl {

// The tables of a frame's plan on the device.
class PlanTables
{
public:
    void upload(const FramePlan& plan);
    void bind() const; // kStorageRegions, kStorageHalfSpaces, kStorageLights, kStorageWarps

    // One region's row by itself, on the device, to be read as a uniform block.
    void copyRegion(std::size_t index, Buffer& to) const;

    // The tables as they are there, where the device has made some of them; waits for it.
    struct Content
    {
        std::vector<shared::ShadowRegion> regions;
        std::vector<shared::vec4> halfSpaces;
        std::vector<float> warpKnots;
    };
    Content download() const;

private:
    std::size_t regionCount_ = 0, halfSpaceCount_ = 0, knotCount_ = 0;
    Buffer regions_, halfSpaces_, lights_, warps_;
};

// The maps of all lights: one depth of 32 bits a lixel, 1 near, 0 far and empty.
struct ShadowAtlas
{
    Texture depth; // a 2D array
    Framebuffer framebuffer;

    // Throws GraphicsError, by name, at maps larger than the device's textures or more layers than it has.
    void resize(const Device& device, const FramePlan& plan);
    std::vector<Image<float>> download(int layers) const; // the first ones; waits for the device
};

} // namespace lixel::gl
