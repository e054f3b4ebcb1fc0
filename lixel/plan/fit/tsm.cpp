// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/tsm.h"

#include "lixel/plan/fit/along_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lixel {
namespace {

constexpr double kXi = -0.6; // the 80 % line in [-1, +1], counted from the top

} // namespace

double tsmDistance(double lambda, double delta)
{
    const double denominator = lambda - 2 * delta - lambda * kXi;
    if (!(denominator > 0)) return std::numeric_limits<double>::infinity();
    return lambda * delta * (1 + kXi) / denominator;
}

FitResult fitTsm(const FitInput& input, std::optional<double> focusDepth)
{
    const auto body = visibleBody(input);
    if (!body) return Unexpected{body.error()};

    const DepthSpan depths = seenDepths(input, viewDepth(input.view, input.originWorld), body->points);
    if (const auto line = lineOfSight(input, *body, depths)) {
        const double focus = std::clamp(focusDepth.value_or(std::sqrt(depths.nearest * depths.farthest)),
                                        depths.nearest, depths.farthest);
        const double delta = placeAlong(*line, body->frame, line->at(focus));
        const double distance = tsmDistance(line->length, delta);
        if (delta > 0 && std::isfinite(distance)) return fitAlong(input, *body, *line, distance);
    }
    return fitTightly(*body, RectangleKind::LeastArea, input);
}

} // namespace lixel
