// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/observation.h"
#include "lixel/base/visibility.h"
#include "lixel/shared/observe.h"

#include <span>

namespace lixel {

// The observation of a picture whose samples and their visibility are known: the twin of what passes make on a device, by the
// same text (lixel/shared/observe.h). Of several samples in a pixel the first is taken. `visibility` has one entry a light, or
// none where nothing was looked up; a light without values is lit. Lights behind the first 32 of the list are not observed.
//
//   Differs  Chong & Gortler 2007 (2.4) threshold the acceleration of z between pixels, which marks edges as well; see
//            lxIsDepthJump(), which asks whether the two tangent planes meet between the samples
Observation observe(const ViewSamples& picture, const View& view, std::span<const Light> lights,
                    std::span<const Visibility> visibility, ObservationGrid grid = {});

// The grid that a picture of this size is observed by: at most a cell a pixel.
ObservationGrid gridWithin(ObservationGrid grid, const View& view);

// A grid of cells as a pass wrote them, and the observation that it holds; `out` is filled anew, in the storage it has.
struct ObservedFrame
{
    View view;
    Vec3d originWorld;
    ObservationGrid grid; // of the cells
    bool hasLights = false;
};
void listCells(std::span<const shared::ObservedPoint> cells, const ObservedFrame& frame, Observation& out);

} // namespace lixel
