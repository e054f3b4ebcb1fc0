// SPDX-License-Identifier: MIT
#pragma once

#include "exit_code.h"
#include "output.h"
#include "run_results.h"
#include "study.h"

#include <string>

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

} // namespace lixel::app
