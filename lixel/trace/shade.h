// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/base/light.h"
#include "lixel/base/surfaces.h"
#include "lixel/base/view_samples.h"
#include "lixel/base/visibility.h"
#include "lixel/trace/trace_scene.h"

#include <span>

namespace lixel {

// The picture without OpenGL, by the same functions (lixel/shared/shading.h): base colours, lights and sky, tone mapped. One
// Visibility a light; an empty one counts as lit. The first sample of a pixel gives its colour; pixels without one show the
// background. Row 0 is the bottom.
Image<Rgba8> shadeTraced(const TraceScene& scene, std::span<const Light> lights, const ViewSamples& samples,
                         std::span<const Visibility> visibility);

} // namespace lixel
