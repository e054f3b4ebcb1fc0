// SPDX-License-Identifier: MIT
#include "run_results.h"

#include <ctime>

#include <fmt/chrono.h>

namespace lixel::app {

RunTiming timingNow(double totalSeconds, const std::string& host)
{
    return {fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))), host, totalSeconds};
}

void finishResults(RunResults& results, const std::string& commandLine, double totalSeconds, const std::string& host)
{
    sortByKey(results.rows);
    results.lixelVersion = LIXEL_VERSION;
    results.command = commandLine;
    results.timing = timingNow(totalSeconds, host);
}

} // namespace lixel::app
