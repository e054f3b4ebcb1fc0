// SPDX-License-Identifier: MIT
#include "progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sys/ioctl.h>
#include <unistd.h>

#include <fmt/format.h>

namespace lixel::app {
namespace {

constexpr double kAlike = 3;         // a step that takes longer than so many of those before is not like them
constexpr double kFirstShare = 0.01; // of a loop, from which its end is foretold

double secondsSince(std::chrono::steady_clock::time_point begin)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// 0:07, 12:34, 1:02:03
std::string asClock(double seconds)
{
    const auto all = static_cast<long long>(std::lround(seconds));
    if (all < 3600) return fmt::format("{}:{:02}", all / 60, all % 60);
    return fmt::format("{}:{:02}:{:02}", all / 3600, all / 60 % 60, all % 60);
}

int terminalColumns()
{
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? int(size.ws_col) : 80;
}

// The bar gives way to what is said in numbers.
int barWidthIn(int columns)
{
    if (columns < 40) return 0;
    return columns < 64 ? 8 : 24;
}

// So that the line never wraps: a wrapped one could not be taken away. Bytes that go on with a character count nothing; from
// U+1000 on a character may be two columns wide, and counts so.
std::string cutTo(int columns, std::string line)
{
    int taken = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const auto byte = static_cast<unsigned char>(line[i]);
        if ((byte & 0xc0) == 0x80) continue;
        taken += byte >= 0xe1 ? 2 : 1;
        if (taken >= columns) return line.substr(0, i);
    }
    return line;
}

} // namespace

bool Progress::isThere = false;

Progress::Progress(std::string_view what, int steps) : what_(what), steps_(std::max(steps, 1))
{
    if (isThere || isatty(STDERR_FILENO) != 1) return;
    isThere = true;
    ticker_ = std::thread([this] { tick(); });
}

Progress::~Progress()
{
    if (!ticker_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
    }
    isOver_.notify_one();
    ticker_.join();
    isThere = false;
    if (isDrawn_) std::fputs("\r\033[K", stderr);
}

void Progress::step(std::string_view now)
{
    if (!ticker_.joinable()) return;
    const std::lock_guard lock(mutex_);
    begun_ = std::min(begun_ + 1, steps_);
    stepBegin_ = Clock::now();
    now_ = now;
    if (isDrawn_) draw();
}

void Progress::tick()
{
    std::unique_lock lock(mutex_);
    while (!isOver_.wait_for(lock, std::chrono::seconds(1), [this] { return over_; })) draw();
}

void Progress::draw()
{
    const int done = std::max(begun_ - 1, 0);
    const double passed = secondsSince(begin_), inStep = secondsSince(stepBegin_);
    const double aStep = done > 0 ? (passed - inStep) / done : 0;
    const std::optional<LoopWatch::State> loop = loop_.running();
    const double share = loop ? loop->share : 0;

    std::optional<double> left;
    if (share > kFirstShare) left = secondsSince(loop->begin) * (1 - share) / share + aStep * (steps_ - done - 1);
    else if (done > 1 && inStep < kAlike * aStep) left = std::max(aStep - inStep, 0.0) + aStep * (steps_ - done - 1);

    shownShare_ = std::max(shownShare_, (done + share) / steps_);
    const int columns = terminalColumns(), width = barWidthIn(columns);
    const int filled = std::min(int(width * shownShare_), width);
    std::string line = what_ + " ";
    if (width > 0) line += fmt::format("[{:=<{}}{:{}}] ", "", filled, "", width - filled);
    if (steps_ > 1) line += fmt::format("{}/{} ", done, steps_);
    line += asClock(passed);
    if (left) line += fmt::format(", {} left", asClock(*left));
    if (!now_.empty()) line += fmt::format("  {}", now_);
    if (loop) line += fmt::format(" {:.0f} %", 100 * share);
    std::fputs(("\r\033[K" + cutTo(columns, std::move(line))).c_str(), stderr);
    std::fflush(stderr);
    isDrawn_ = true;
}

} // namespace lixel::app
