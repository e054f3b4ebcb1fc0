// SPDX-License-Identifier: MIT
#include "progress.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>

namespace lixel::app {

Progress::Progress(std::string_view what, int steps)
    : what_(what), steps_(std::max(steps, 1)), isTerminal_(isatty(STDERR_FILENO) == 1)
{
}

Progress::~Progress()
{
    if (isTerminal_) std::fputs("\r\033[K", stderr);
}

void Progress::step(std::string_view now)
{
    begun_ = std::min(begun_ + 1, steps_);
    if (isTerminal_) draw(now);
}

void Progress::draw(std::string_view now) const
{
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (seconds < 1) return;
    const int done = begun_ - 1;
    const int filled = 30 * done / steps_;
    const std::string remaining = done > 0 ? fmt::format("{:.0f} s left", seconds / done * (steps_ - done)) : "";
    std::fputs(fmt::format("\r\033[K{} [{}{}] {}/{} {} {}", what_, std::string(std::size_t(filled), '='),
                           std::string(std::size_t(30 - filled), ' '), done, steps_, remaining, now.substr(0, 60))
                   .c_str(),
               stderr);
    std::fflush(stderr);
}

} // namespace lixel::app
