// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/reproduction.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lixel {

// All experiments of the papers in one run, each with a folder and a page of its own below this one's.
struct Reproductions
{
    struct Entry
    {
        std::string name, paper, question; // name is also the folder's
        std::string leftOut;               // why it was not run; empty where it was
        double seconds = 0;
        std::vector<ReproducedClaim> claims;
    };
    std::string lixelVersion, command;
    bool isQuick = false;
    std::vector<Entry> entries;
    RunTiming timing;
};

// Valid by docs/reproductions.schema.json.
std::string toJson(const Reproductions& all);

// Writes `folder`/report.html: the claims, and the way to each experiment's own page. Throws OutputError.
void writeReport(const std::filesystem::path& folder, const Reproductions& all);

} // namespace lixel
