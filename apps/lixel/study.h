// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace lixel::app {

struct StudyOptions
{
    int count = 0; // of cases; 0: the study's own
    std::uint64_t seed = 2004;
    std::string executor = "gl";
    std::string json;        // where to, or empty
    std::string commandLine; // repeats the run
};

// A question about lixel's own techniques that a table of pictures does not answer. Its run prints what it finds, writes JSON where it is
// asked to, and gives an exit code.
struct Study
{
    std::string name, question;
    int (*run)(const StudyOptions& options);
};

std::span<const Study> studies();

// Their runs, one file each.
int studyOneToOne(const StudyOptions& options);

} // namespace lixel::app
