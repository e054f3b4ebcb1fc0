// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/bench.h"
#include "lixel/report/lookups.h"
#include "lixel/report/plane_budget.h"
#include "lixel/report/reproduction.h"
#include "lixel/report/sweep.h"

#include <filesystem>
#include <string>

namespace lixel::test {

// A folder of its own below the temporary one, gone with it.
class TemporaryFolder
{
public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    ~TemporaryFolder();
    const std::filesystem::path& path() const { return path_; }
    std::size_t fileCount() const;

private:
    std::filesystem::path path_;
};

std::string readWhole(const std::filesystem::path& path);

// A made-up run: two views, `exact` and three techniques on two executors, refusals of a fourth. Its pictures,
// size x size, are written to `folder`: shadows of discs on a chequered floor, stepped by the technique's lixels.
RunResults sampleRun(const std::filesystem::path& folder, int size);

// The same without pictures.
RunResults sampleRun();

// The same along a path: every measured row has flips.
RunResults samplePath(const std::filesystem::path& folder, int size);
RunResults samplePath();

// A made-up experiment: numbers with the paper's and without, of the clock too, and a figure of each view.
Reproduction sampleReproduction(const std::filesystem::path& folder, int size);

// A made-up study: two techniques on planes and off them, one of them at last without errors on them.
PlaneBudget samplePlaneBudget(const std::filesystem::path& folder, int size);

// A made-up study: four lookups, one without a filter's truth, one without times.
LookupStudy sampleLookups(const std::filesystem::path& folder, int size);

// A made-up sweep: two scenes of different size, two views, three techniques at three budgets and two sizes, with one and four
// lights; one technique is refused in a view, and one without errors where lixels are many. Nothing is written.
SweepResults sampleSweep(const std::filesystem::path& folder, int size);

// A made-up bench: two axes, three techniques of known growth; the last point of one is left out.
BenchResults sampleBench(const std::filesystem::path& folder, int size);

} // namespace lixel::test
