// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/focused.h"

#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/stable.h"

namespace lixel {

FitResult fitFocused(const FitInput& input)
{
    if (input.isStable) return fitStable(input);
    const auto body = visibleBody(input);
    if (!body) return Unexpected{body.error()};
    return fitTightly(*body, RectangleKind::LeastArea, input);
}

} // namespace lixel
