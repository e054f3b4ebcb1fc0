// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/observation.h"
#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/point_list.h"
#include "lixel/gl/passes/visibility_list.h"

#include <span>

namespace lixel::gl {

// The cells of an observation (lixel/base/observation.h), from what the view sees and which lights reach it: shared::ObservedPoint
// rows, row by row from the bottom. Nothing of the picture's size leaves the device.
//   reads   PointList with an entry a pixel, VisibilityList (of no light where nothing was looked up)        writes   cells()
class SamplePass
{
public:
    static constexpr const char* kName = "sample";
    explicit SamplePass(const Device& device);

    // `grid` has no more cells than the picture has pixels. Throws GraphicsError, by name, at more cells than one binding takes.
    void run(const PointList& points, const VisibilityList& visibility, std::span<const Light> lights,
             ObservationGrid grid);

    const Buffer& cells() const { return cells_; }
    std::size_t bytes() const { return bytes_; } // of the cells of the last run

private:
    const Device* device_;
    Program sample_, neighbours_;
    Buffer cells_, lights_;
    std::size_t bytes_ = 0;
};

} // namespace lixel::gl
