// SPDX-License-Identifier: MIT
#pragma once

#include "exit_code.h"
#include "lixel/report/html.h"
#include "lixel/report/write_file.h"
#include "output.h"
#include "run_results.h"
#include "study.h"

#include <cstdio>
#include <filesystem>
#include <string>

#include <fmt/format.h>

namespace lixel::app {

// The end of a study with JSON of its own: what repeats the run goes into it, it is written where it is asked for, and printed for people.
// `print(study, FILE*)` leaves stdout to the JSON where that goes there.
template <typename Study, typename Print>
int finishStudy(Study& study, const StudyOptions& options, double seconds, const std::string& host, const Print& print)
{
    study.lixelVersion = LIXEL_VERSION;
    study.command = options.commandLine;
    study.timing = timingNow(seconds, host);
    if (!options.json.empty()) writeOrPrint(options.json, toJson(study));
    print(study, options.json == "-" ? stderr : stdout);
    return kDone;
}

// The end of a study with rows of results and a page.
template <typename Study, typename Print>
int finishStudyOfRows(const Study& study, const StudyOptions& options, const Print& print)
{
    const std::string json = toJson(study);
    if (!options.json.empty()) writeOrPrint(options.json, json);
    std::FILE* const told = options.json == "-" ? stderr : stdout;
    print(study, told);
    if (options.output.empty()) return kDone;
    const std::filesystem::path folder = options.output;
    writeFileAtomically(folder / "results.json", json);
    writeReport(folder, study);
    fmt::print(told, "report: {}\n", (folder / "report.html").string());
    return kDone;
}

} // namespace lixel::app
