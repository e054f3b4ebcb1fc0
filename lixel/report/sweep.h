// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The rows of `lixel study FILE.json`, as text: a row is made once, kept in a file, and written again as it was. docs/studies.md
// describes them.
namespace lixel {

// What a row of a sweep says besides those of other runs.
struct SweepRowPlace
{
    std::size_t number = 0; // among all rows of the study, from 0
    std::string key;        // the members that tell it from the others, in one text
    double timeSeconds = 0; // of the scene's animation
    std::string lights;     // the set that the light is of
    std::size_t lightCount = 0;
    std::uint64_t triangles = 0; // drawn or not, of the scene at its time
    std::string host;            // that measured it
};

// A JSON object in one line without a break. Its last member is `timing`: all that depends on clock and machine.
std::string sweepRowLine(const ResultRow& row, const SweepRowPlace& place, const std::string& lixelVersion);

// What is read again of such a line.
struct SweepRowName
{
    std::size_t number = 0;
    std::string key;
    bool isRefused = false;
};
std::optional<SweepRowName> nameOfSweepRow(std::string_view line);

// Rows in the order of their numbers, as they are written at the end. `withTiming`: false leaves `timing` out.
std::string toJsonLines(const std::vector<std::string>& lines, bool withTiming);
std::string toCsv(const std::vector<std::string>& lines, bool withTiming);

// All of them with what made them, for the report.
struct SweepResults
{
    std::string name, question; // of the study
    std::string lixelVersion, command;
    std::uint64_t seed = 0;
    std::vector<std::string> lines;
    RunTiming timing;
};

// JSON as toJson(RunResults) writes it, with `sweep` beside `results`.
std::string toJson(const SweepResults& sweep);

} // namespace lixel
