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

// One experiment of a paper, run again.
struct Reproduction
{
    std::string name, paper, question;
    bool isQuick = false;
    std::vector<std::pair<std::string, std::string>> parameters;
    std::vector<ReproducedNumber> numbers;
    RunResults run; // what the numbers were made from
};

// JSON as toJson(RunResults) writes it, with `reproduction` {name, paper, question, quick, parameters, numbers} beside `results`.
std::string toJson(const Reproduction& reproduction);

} // namespace lixel
