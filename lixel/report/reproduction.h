// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lixel {

// One number of a paper's experiment, measured again.
struct ReproducedNumber
{
    std::string key;  // within the experiment, e.g. "normal over focused, all lights"
    std::string unit; // "ratio", "percent of the picture", ...
    double ours = 0;
    std::optional<double> papers; // no value where the paper gives none
    std::string source;           // where in the paper
};

// Pictures beside each other, whole and enlarged, as papers show them.
struct PictureRow
{
    std::string title;                   // what the paper's figure shows there
    std::string scene, view, light;      // of the rows
    std::vector<std::string> techniques; // of the rows, as they were typed; from left to right
    int left = 0, top = 0, side = 0;     // the square that is enlarged, pixels from the picture's upper left
};

// One experiment of a paper, run again.
struct Reproduction
{
    std::string name, paper, question;
    bool isQuick = false;
    std::vector<std::pair<std::string, std::string>> parameters;
    std::vector<ReproducedNumber> numbers;
    std::vector<ReproducedNumber> timingNumbers; // those that depend on the clock and the machine
    std::vector<PictureRow> figures;             // of rows with pictures
    RunResults run;                              // what the numbers were made from
};

// JSON as toJson(RunResults) writes it, with `reproduction` beside `results`.
std::string toJson(const Reproduction& reproduction);

} // namespace lixel
