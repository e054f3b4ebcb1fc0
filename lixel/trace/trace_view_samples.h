// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view.h"
#include "lixel/base/view_samples.h"
#include "lixel/trace/trace_scene.h"

namespace lixel {

// What the view sees: one sample a pixel centre, by rays, row by row from the bottom. Pixels that see nothing have no
// sample. Positions are relative to the scene's originWorld; normals are those of the triangles, turned to the eye.
ViewSamples traceViewSamples(const TraceScene& scene, const View& view);

} // namespace lixel
