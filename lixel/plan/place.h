// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/fit.h"
#include "lixel/plan/light_image.h"
#include "lixel/plan/lookup/lookup.h"

namespace lixel {

// Puts a fit, which knows nothing of resolution, into its rectangle of the atlas: turned by a right angle where that brings its
// longer side along the rectangle's, and shrunk so that the lookup's whole reach around every receiver stays inside (the
// guard band). A fit that snaps to the world is moved by half a lixel at most, which the guard band has room for, so that lixel borders
// lie on one grid fixed in the world (M. Valient. ShaderX 6, 2008); turns and guard bands are our own. Where a side has no room for the
// reach, half a lixel in its middle is left for receivers. A fit of whole pixels (Fit::pixels) is not turned, and its band is whole lixels.
// `turn` says whether it is turned, where that is known. The NDC square of what it returns is the whole rectangle.
LightProjection place(const Fit& fit, const LixelRectangle& rectangle, const LookupLayout& lookup, Vec3d originWorld,
                      std::optional<bool> turn = {});

// Lixels at the borders of a rectangle, along x and y, from where the lookup would reach beyond it: no receiver that place() knows of lies there, but
// for a tenth of a lixel of rounding.
Vec2d guardBand(const LixelRectangle& rectangle, const LookupLayout& lookup);

} // namespace lixel
