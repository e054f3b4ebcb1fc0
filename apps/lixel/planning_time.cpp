// SPDX-License-Identifier: MIT
#include "planning_time.h"

#include "lixel/base/median.h"
#include "run_results.h"

#include <utility>
#include <vector>

namespace lixel::app {

double planningMs(const PlanInput& input, int plans)
{
    FitScratch scratch;
    FramePlan plan;
    std::vector<double> ms;
    for (int i = 0; i < plans; ++i) {
        const Stopwatch watch;
        plan = planShadows(input, scratch, std::move(plan));
        ms.push_back(1e3 * watch.seconds());
    }
    return median(std::move(ms));
}

} // namespace lixel::app
