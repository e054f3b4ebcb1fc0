// SPDX-License-Identifier: MIT
#include "report/sample_results.h"
#include "run_command.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>

// What somebody sees who waits: on a terminal, a line that is drawn anew every second.
namespace lixel::test {
namespace {

constexpr int kColumns = 70;

std::vector<std::string> linesDrawn(std::string_view shown)
{
    constexpr std::string_view kAnew = "\r\033[K";
    std::vector<std::string> lines;
    for (std::size_t at = shown.find(kAnew); at != shown.npos;) {
        const std::size_t next = shown.find(kAnew, at + kAnew.size());
        lines.emplace_back(shown.substr(at + kAnew.size(), next - at - kAnew.size()));
        at = next;
    }
    return lines;
}

// How many different moments of work on the shadows were told with a share of it and the time left.
int momentsTold(std::string_view shown)
{
    constexpr std::string_view kBefore = "render [", kAfter = "] ";
    constexpr std::size_t kBar = 24, kNumbers = kBefore.size() + kBar + kAfter.size();
    std::set<int> moments;
    for (const std::string& line : linesDrawn(shown)) {
        if (!line.starts_with(kBefore) || line.find(kAfter) != kBefore.size() + kBar) continue;
        int minutes = 0, seconds = 0, minutesLeft = 0, secondsLeft = 0, share = 0;
        if (std::sscanf(line.c_str() + kNumbers, "2/4 %d:%2d, %d:%2d left  shadows %d %%", &minutes, &seconds,
                        &minutesLeft, &secondsLeft, &share) == 5)
            moments.insert(60 * minutes + seconds);
    }
    return int(moments.size());
}

TEST(Progress, OneLongStepIsToldEverySecond)
{
    const TemporaryFolder folder;
    CommandOptions options;
    options.folder = folder.path();
    options.terminalColumns = kColumns;
    options.interruptWhenShown = [](std::string_view shown) { return momentsTold(shown) >= 3; };
    const CommandResult run = runLixel(
        {"render", "table", "--executor", "trace", "--size", "800x800", "--technique", "exact-area:256", "-o", "a.png"},
        options);
    EXPECT_EQ(run.exitCode, 130);
    EXPECT_GE(momentsTold(run.err), 3) << run.err;
    for (const std::string& line : linesDrawn(run.err)) EXPECT_LT(line.substr(0, line.find('\r')).size(), kColumns);
    EXPECT_TRUE(run.err.ends_with("\r\nlixel: interrupted\r\n")) << run.err;
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

// Where there is little room, what is said in numbers stays.
TEST(Progress, ANarrowTerminalHasTheNumbers)
{
    const TemporaryFolder folder;
    CommandOptions options;
    options.folder = folder.path();
    options.terminalColumns = 20;
    options.interruptWhenShown = [](std::string_view shown) { return !linesDrawn(shown).empty(); };
    const CommandResult run = runLixel(
        {"render", "table", "--executor", "trace", "--size", "800x800", "--technique", "exact-area:256", "-o", "a.png"},
        options);
    ASSERT_FALSE(linesDrawn(run.err).empty());
    const std::string line = linesDrawn(run.err).front();
    EXPECT_TRUE(line.starts_with("render ")) << line;
    EXPECT_NE(line.find("/4 0:0"), line.npos) << line;
    EXPECT_LT(line.substr(0, line.find('\r')).size(), 20u);
}

TEST(Progress, ShortWorkShowsNothing)
{
    const TemporaryFolder folder;
    CommandOptions options;
    options.folder = folder.path();
    options.terminalColumns = kColumns;
    const CommandResult run =
        runLixel({"render", "table", "--executor", "trace", "--size", "32x32", "-o", "a.png"}, options);
    EXPECT_EQ(run.exitCode, 0);
    // On a busy machine it may be drawn; then it is taken away.
    EXPECT_TRUE(run.err.empty() || run.err.ends_with("\r\033[K")) << run.err;
}

} // namespace
} // namespace lixel::test
