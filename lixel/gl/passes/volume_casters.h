// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/caster_source.h"
#include "lixel/base/view.h"
#include "lixel/gl/device/device.h"
#include "lixel/gl/device/objects.h"
#include "lixel/gl/volume_failure.h"

#include <cstdint>
#include <optional>

namespace lixel::gl {

// Casters as shadow volumes need them on the device: all triangles as they were given, and their edges. Edges are found on the CPU
// when the version is a new one; which of them are silhouettes is the device's to find.
class VolumeCasters
{
public:
    explicit VolumeCasters(const Device& device) : device_(&device) {}

    // As Surfaces::update(). Throws GraphicsError, by name, at more triangles than one binding takes.
    void update(const CasterBuffers& casters);

    void bind() const; // indices, positions, edges and their uses
    std::uint32_t triangleCount() const { return triangleCount_; }
    std::uint32_t edgeCount() const { return edgeCount_; }
    Vec3d originWorld() const { return originWorld_; }

private:
    const Device* device_;
    std::uint64_t version_ = 0;
    Vec3d originWorld_;
    std::uint32_t triangleCount_ = 0, edgeCount_ = 0;
    Buffer indices_, positions_, edges_, uses_;
};

// What shadow volumes cannot do; nothing where they can be had.
std::optional<VolumeFailure> whyNoVolumes(const CasterBuffers& casters, const View& view);

} // namespace lixel::gl
