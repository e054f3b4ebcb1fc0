// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/trace/parallel.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace lixel::app {

// A bar on a terminal, for work longer than a second, drawn anew every second: steps done, time passed, and the time that is left
// where it can be told, from steps alike or from the loop that the thread of this object runs. Nothing where stderr is
// not a terminal, or while another bar is there.
class Progress
{
public:
    Progress(std::string_view what, int steps);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress(); // takes the bar away

    void step(std::string_view now); // begins the next step

private:
    using Clock = std::chrono::steady_clock;

    void tick();
    void draw(); // with mutex_ held

    static bool isThere; // one of them

    const std::string what_;
    const int steps_;
    const Clock::time_point begin_ = Clock::now();
    LoopWatch loop_;

    std::mutex mutex_;
    std::condition_variable isOver_;
    int begun_ = 0;
    double shownShare_ = 0; // of all steps; never goes back
    Clock::time_point stepBegin_ = begin_;
    std::string now_;
    bool over_ = false, isDrawn_ = false;
    std::thread ticker_; // last: it uses what is above
};

} // namespace lixel::app
