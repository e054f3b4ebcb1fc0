// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/shadow_plan.h"

namespace lixel::app {

// What a plan costs on the processor once memory is there: the median, in milliseconds, of as many plans in a row.
double planningMs(const PlanInput& input, int plans);

} // namespace lixel::app
