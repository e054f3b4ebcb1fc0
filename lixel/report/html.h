// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/bench.h"
#include "lixel/report/lookups.h"
#include "lixel/report/plane_budget.h"
#include "lixel/report/reproduction.h"
#include "lixel/report/sweep.h"

#include <filesystem>

namespace lixel {

// Writes `folder`/report.html: the run's tables, charts and pictures in one file that needs no network and nothing
// beside it. The pictures are read from `folder`, where the rows' PictureFiles must already stand.
// Throws OutputError when it cannot be written, std::runtime_error when a picture cannot be read.
void writeReport(const std::filesystem::path& folder, const RunResults& results);

// The same with the paper's numbers beside ours, and its figures.
void writeReport(const std::filesystem::path& folder, const Reproduction& reproduction);

// The same with the curves.
void writeReport(const std::filesystem::path& folder, const PlaneBudget& study);

// The same with every lookup's errors against what it takes.
void writeReport(const std::filesystem::path& folder, const LookupStudy& study);

// Of a sweep: plots of error, cost and growth, and its rows.
void writeReport(const std::filesystem::path& folder, const SweepResults& sweep);

// Of a bench: plots of growth, with their exponents.
void writeReport(const std::filesystem::path& folder, const BenchResults& bench);

} // namespace lixel
