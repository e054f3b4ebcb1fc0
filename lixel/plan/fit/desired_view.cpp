// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/desired_view.h"

#include "lixel/plan/fit/light_frame.h"

namespace lixel {

FitResult fitDesiredView(const FitInput& input, bool isRotated)
{
    if (input.sceneLocal.isEmpty()) return Unexpected{FitFailure::EmptyScene};
    if (!input.hasViewSamples) return Unexpected{FitFailure::NoViewSamples};
    if (input.seenLocal.empty()) return Unexpected{FitFailure::NothingInView};
    const auto body = frameAround(input, input.seenLocal);
    if (!body) return Unexpected{body.error()};
    Fit fit = fitTightly(*body, isRotated ? RectangleKind::LeastArea : RectangleKind::Upright, input);
    fit.isOfSamples = true;
    return fit;
}

} // namespace lixel
