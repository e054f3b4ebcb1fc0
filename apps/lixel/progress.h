// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace lixel::app {

// A bar with the remaining time on a terminal, for work longer than a second; nothing where stderr is not a terminal.
class Progress
{
public:
    Progress(std::string_view what, int steps);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress(); // takes the bar away

    void step(std::string_view now); // begins the next step
private:
    void draw(std::string_view now) const;

    std::string what_;
    int steps_, begun_ = 0;
    bool isTerminal_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace lixel::app
