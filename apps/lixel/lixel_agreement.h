// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/plan/shadow_plan.h"

#include <cstdint>
#include <span>

namespace lixel::app {

// Lixels of a light's maps, as two executors made them: those whose depths are the same but for 1e-4 of the range.
struct LixelAgreement
{
    std::int64_t lixels = 0, agreeing = 0;

    double percent() const { return lixels > 0 ? 100.0 * double(agreeing) / double(lixels) : 100; }
    LixelAgreement& operator+=(const LixelAgreement& other)
    {
        lixels += other.lixels, agreeing += other.agreeing;
        return *this;
    }
};

// Maps have an image a layer of the plan's atlas.
LixelAgreement lixelAgreement(const ShadowPlan& light, std::span<const Image<float>> one,
                              std::span<const Image<float>> other);

} // namespace lixel::app
