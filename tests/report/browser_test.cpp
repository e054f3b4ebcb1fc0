// SPDX-License-Identifier: MIT
#include "lixel/report/html.h"

#include "in_browser.h"
#include "sample_results.h"

#include <gtest/gtest.h>

namespace lixel::test {
namespace {

template <typename Results>
void useInABrowser(Results (*sample)(const std::filesystem::path& folder, int size), const std::string& name)
{
    const TemporaryFolder folder;
    writeReport(folder.path(), sample(folder.path(), 512));
    const InBrowser used = useInBrowser(folder.path() / "report.html", name);
    if (used == InBrowser::NoBrowser) GTEST_SKIP() << "needs chromium and chromedriver";
    EXPECT_EQ(used, InBrowser::Usable);
}

TEST(Report, IsUsableInABrowserFromAFile) { useInABrowser<RunResults>(sampleRun, "pictures"); }
TEST(Report, OfAPathIsUsableInABrowserFromAFile) { useInABrowser<RunResults>(samplePath, "path"); }
TEST(Report, OfAnExperimentIsUsableInABrowserFromAFile)
{
    useInABrowser<Reproduction>(sampleReproduction, "experiment");
}
TEST(Report, OfASweepIsUsableInABrowserFromAFile) { useInABrowser<SweepResults>(sampleSweep, "sweep"); }
TEST(Report, OfABenchIsUsableInABrowserFromAFile) { useInABrowser<BenchResults>(sampleBench, "bench"); }
TEST(Report, OfAStudyIsUsableInABrowserFromAFile) { useInABrowser<PlaneBudget>(samplePlaneBudget, "study"); }
TEST(Report, OfLookupsIsUsableInABrowserFromAFile) { useInABrowser<LookupStudy>(sampleLookups, "lookups"); }

} // namespace
} // namespace lixel::test
