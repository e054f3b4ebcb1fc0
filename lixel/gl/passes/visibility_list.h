// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/visibility.h"
#include "lixel/gl/passes/point_list.h"

#include <span>
#include <vector>

namespace lixel::gl {

// A visibility for every entry of a PointList and every light, on the device; negative where no region serves the entry. It
// lies part by part, within a part light by light, so that shaders see all lights of a part in one binding.
class VisibilityList
{
public:
    using Part = PointList::Part;

    void resize(const PointList& points, std::size_t lights);

    // values[light][entry]; for pictures with visibility from elsewhere.
    void upload(std::span<const std::vector<float>> values);

    // Waits for the device. One Visibility a light, a value an entry.
    std::vector<Visibility> download() const;

    // The parts of the points that are to be worked on one after the other.
    const std::vector<Part>& parts() const { return parts_; }
    // visibility[light * part.count + entry], to kStorageVisibility.
    void bind(const Part& part) const;
    std::size_t lights() const { return lights_; }

private:
    std::size_t offset(std::size_t light, const Part& part) const
    {
        return sizeof(float) * (lights_ * part.first + light * part.count);
    }

    Buffer values_;
    std::vector<Part> parts_;
    std::size_t lights_ = 0, size_ = 0;
};

} // namespace lixel::gl
