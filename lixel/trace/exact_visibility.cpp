// SPDX-License-Identifier: MIT
#include "lixel/trace/exact_visibility.h"

#include "lixel/base/assert.h"
#include "lixel/trace/parallel.h"
#include "lixel/trace/shadow_ray.h"

namespace lixel {

std::vector<float> exactVisibility(const TraceScene& scene, const ViewSamples& samples, const Light& light)
{
    LX_ASSERT(samples.originWorld == scene.originWorld());
    std::vector<float> visibility(samples.size(), 0.0f);
    forEachBlock(samples.size(), 2048, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const SurfacePoint sample = surfacePoint(samples, i);
            const Vec3d p = toDouble(sample.positionLocal), n = toDouble(sample.normal);
            if (isLightFacing(light, scene.originWorld(), p, n) && !isInShadow(scene, sample, light)) visibility[i] = 1;
        }
    });
    return visibility;
}

} // namespace lixel
