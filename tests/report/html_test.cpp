// SPDX-License-Identifier: MIT
#include "lixel/report/html.h"

#include "lixel/report/base64.h"
#include "lixel/report/write_file.h"
#include "sample_results.h"

#include <gtest/gtest.h>

namespace lixel::test {
namespace {

std::size_t countOf(const std::string& text, std::string_view wanted)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at + 1)) ++count;
    return count;
}

// RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandardsExamples)
{
    EXPECT_EQ(toBase64(""), "");
    EXPECT_EQ(toBase64("f"), "Zg==");
    EXPECT_EQ(toBase64("fo"), "Zm8=");
    EXPECT_EQ(toBase64("foo"), "Zm9v");
    EXPECT_EQ(toBase64("foob"), "Zm9vYg==");
    EXPECT_EQ(toBase64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(toBase64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(toBase64(std::string("\xff\xfe\x00", 3)), "//4A");
}

TEST(Report, NamesNothingOutsideItself)
{
    const TemporaryFolder folder;
    writeReport(folder.path(), sampleRun(folder.path(), 48));
    const std::string page = readWhole(folder.path() / "report.html");
    EXPECT_EQ(countOf(page, "src=\""), 0u);
    EXPECT_EQ(countOf(page, "<link"), 0u);
    EXPECT_EQ(countOf(page, "@import"), 0u);
    EXPECT_EQ(countOf(page, "url("), 0u);
    EXPECT_EQ(countOf(page, "{{"), 0u); // every place of the template is filled
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

TEST(Report, HoldsEveryPictureOnce)
{
    const TemporaryFolder folder;
    writeReport(folder.path(), sampleRun(folder.path(), 48));
    const std::string page = readWhole(folder.path() / "report.html");
    EXPECT_EQ(countOf(page, "type=\"text/plain\" id=\"picture-"),
              2u * 4 * 2 * 4); // views, techniques, executors, kinds
}

// Pictures of one view differ along shadows only.
TEST(Report, StoresMostShadedPicturesAsDifferences)
{
    const TemporaryFolder folder;
    writeReport(folder.path(), sampleRun(folder.path(), 48));
    EXPECT_EQ(countOf(readWhole(folder.path() / "report.html"), "data-over=\""), 2u * 3 * 2); // all but exact's
}

TEST(Report, NoNameEndsItsScripts)
{
    const TemporaryFolder folder;
    RunResults hostile = sampleRun();
    const std::size_t scripts = [&] {
        writeReport(folder.path(), hostile);
        return countOf(readWhole(folder.path() / "report.html"), "</script");
    }();
    hostile.command = "lixel compare '</script><script>alert(1)</script><!--'";
    for (ResultRow& row : hostile.rows) row.scene = row.view = "</script><img onerror=alert(1)>";
    writeReport(folder.path(), hostile);
    const std::string page = readWhole(folder.path() / "report.html");
    EXPECT_EQ(countOf(page, "</script"), scripts);
    EXPECT_EQ(countOf(page, "<img"), 0u);
    EXPECT_EQ(countOf(page, "alert(1)<!--"), 0u);
    EXPECT_EQ(countOf(page, "\\u003c/script>\\u003cscript>alert(1)"), 1u);
}

TEST(Report, IsTheSameForTheSameResults)
{
    const TemporaryFolder folder;
    RunResults run = sampleRun(folder.path(), 48);
    writeReport(folder.path(), run);
    const std::string first = readWhole(folder.path() / "report.html");
    std::reverse(run.rows.begin(), run.rows.end());
    writeReport(folder.path(), run);
    EXPECT_EQ(readWhole(folder.path() / "report.html"), first);
}

TEST(Report, LeavesNothingBehindWhenAPictureIsMissing)
{
    const TemporaryFolder folder;
    RunResults run = sampleRun();
    for (ResultRow& row : run.rows)
        if (auto* measured = std::get_if<Measurement>(&row.outcome)) measured->pictures.shaded = "not there.png";
    EXPECT_THROW(writeReport(folder.path(), run), std::runtime_error);
    EXPECT_EQ(folder.fileCount(), 0u);
}

} // namespace
} // namespace lixel::test
