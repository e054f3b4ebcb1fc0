// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/trace/shadow_ray.h"

#include <optional>

namespace lixel {

inline bool facesLight(const TraceScene& scene, const SurfacePoint& point, const Light& light)
{
    return isLightFacing(light, scene.originWorld(), toDouble(point.positionLocal), toDouble(point.normal));
}

// The share of some points around a sample that are lit, of those that face the light.
class LitShare
{
public:
    LitShare(const TraceScene& scene, const Light& light) : scene_(scene), light_(light) {}

    void add(const std::optional<SurfacePoint>& point)
    {
        if (!point || !facesLight(scene_, *point, light_)) return;
        ++facing_;
        if (!isInShadow(scene_, *point, light_)) ++lit_;
    }

    // Where none of them faces it, what the sample itself has.
    float around(const SurfacePoint& sample) const
    {
        if (facing_ > 0) return float(lit_) / float(facing_);
        return isInShadow(scene_, sample, light_) ? 0.0f : 1.0f;
    }

private:
    const TraceScene& scene_;
    const Light& light_;
    int facing_ = 0, lit_ = 0;
};

} // namespace lixel
