// SPDX-License-Identifier: MIT
#include "run_results.h"

#include "lixel/report/write_file.h"

#include <cstdio>
#include <ctime>

#include <fmt/chrono.h>

namespace lixel::app {

RunResults beginResults(const std::string& commandLine)
{
    RunResults results;
    results.lixelVersion = LIXEL_VERSION;
    results.command = commandLine;
    return results;
}

void finishResults(RunResults& results, double totalSeconds, const std::string& host)
{
    sortByKey(results.rows);
    results.timing.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    results.timing.host = host;
    results.timing.totalSeconds = totalSeconds;
}

void writeTextOrPrint(const std::string& path, const std::string& text)
{
    if (path == "-") std::fwrite(text.data(), 1, text.size(), stdout);
    else writeFileAtomically(path, text);
}

} // namespace lixel::app
