// SPDX-License-Identifier: MIT
#include "lixel_agreement.h"

#include <cmath>

namespace lixel::app {
namespace {

constexpr double kSameDepth = 1e-4; // of the range

} // namespace

LixelAgreement lixelAgreement(const ShadowPlan& light, std::span<const Image<float>> one,
                              std::span<const Image<float>> other)
{
    LixelAgreement counts;
    for (const PlannedRegion& region : light.regions) {
        const LixelRectangle& r = region.rectangle;
        const auto layer = std::size_t(r.layer);
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x) {
                ++counts.lixels;
                counts.agreeing += std::abs(double(one[layer](x, y)) - double(other[layer](x, y))) <= kSameDepth;
            }
    }
    return counts;
}

} // namespace lixel::app
