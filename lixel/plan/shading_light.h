// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/shared/shading.h"

namespace lixel {

// A light as pictures are shaded with it, in Local space; see lixel/shared/shading.h.
shared::ShadingLight shadingLight(const Light& light, Vec3d originWorld);

} // namespace lixel
