// SPDX-License-Identifier: MIT
#pragma once

#include "sweep/row_log.h"

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

// `lixel study FILE.json`: rows for every combination that the file asks for, each kept as soon as it is there.
namespace lixel::app {

struct SweepOptions
{
    std::string file, output, shard = "1/1";
    bool restart = false;
    bool withoutTiming = false;
    std::string commandLine; // repeats the run
};
void addSweepOptions(CLI::App& app, SweepOptions& options);

// Goes on where an earlier run in the folder has ended. Gives an exit code.
int runSweep(const SweepOptions& options);

// results.jsonl, results.csv and report.html in the folder, of rows that are all there.
struct SweepEnd
{
    const RowFile& file;
    std::string commandLine, host;
    double seconds = 0;
    bool withTiming = true;
};
void writeSweepResults(const std::filesystem::path& folder, const SweepEnd& end);

// How many of them were refused.
std::size_t refusedIn(const RowFile& file);

} // namespace lixel::app
