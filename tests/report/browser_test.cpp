// SPDX-License-Identifier: MIT
#include "lixel/report/html.h"

#include "sample_results.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <sys/wait.h>

namespace lixel::test {
namespace {

using SampleRun = RunResults (*)(const std::filesystem::path& folder, int size);

// report_in_browser.py says what is tried; LIXEL_REPORT_SCREENSHOTS=folder keeps pictures of the page, in `name` there.
void useInABrowser(SampleRun sample, const std::string& name)
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

TEST(Report, IsUsableInABrowserFromAFile) { useInABrowser(sampleRun, "pictures"); }
TEST(Report, OfAPathIsUsableInABrowserFromAFile) { useInABrowser(samplePath, "path"); }

} // namespace
} // namespace lixel::test
