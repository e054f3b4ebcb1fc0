// SPDX-License-Identifier: MIT
#include "lixel/report/html.h"

#include "sample_results.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <sys/wait.h>

namespace lixel::test {
namespace {

// report_in_browser.py says what is tried; LIXEL_REPORT_SCREENSHOTS=folder keeps pictures of the page, in `name` there.
template <typename Results>
void useInABrowser(Results (*sample)(const std::filesystem::path& folder, int size), const std::string& name)
{
    constexpr int kNoBrowser = 77;
    const TemporaryFolder folder;
    writeReport(folder.path(), sample(folder.path(), 512));

    std::string command = "python3 '" LIXEL_SOURCE_DIR "/tests/report/report_in_browser.py' '" +
                          (folder.path() / "report.html").string() + "'";
    if (const char* screenshots = std::getenv("LIXEL_REPORT_SCREENSHOTS"))
        command += " --screenshots '" + std::string(screenshots) + "/" + name + "'";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == kNoBrowser) GTEST_SKIP() << "needs chromium and chromedriver";
    EXPECT_EQ(WEXITSTATUS(status), 0);
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
