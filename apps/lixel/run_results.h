// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <chrono>
#include <string>

// What all commands do around the rows of a run.
namespace lixel::app {

inline constexpr int kMostLixelsASide = 16384;

class Stopwatch
{
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// When and where a run was, now that it ends.
RunTiming timingNow(double totalSeconds, const std::string& host);

// Sorts the rows and fills in what made them. `commandLine` repeats the run.
void finishResults(RunResults& results, const std::string& commandLine, double totalSeconds, const std::string& host);

} // namespace lixel::app
