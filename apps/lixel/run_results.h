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

RunResults beginResults(const std::string& commandLine);
void finishResults(RunResults& results, double totalSeconds, const std::string& host); // sorts rows, fills `timing`

// A file, or standard output for "-".
void writeTextOrPrint(const std::string& path, const std::string& text);

} // namespace lixel::app
