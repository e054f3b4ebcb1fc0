// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/bench.h"

#include <string>
#include <string_view>
#include <vector>

// What `lixel bench` varies, one thing at a time.
namespace lixel::app {

// All that a measurement depends on besides the technique.
struct BenchPoint
{
    int triangles = 100'000; // of the scene `balls`, about
    int side = 1024;         // of the picture, pixels
    int mapSide = 1024;      // of the budget of a light, lixels
    int lights = 1;          // suns

    std::string scene() const;
};

struct BenchSeries
{
    BenchAxis axis;
    std::vector<BenchPoint> points; // sizes rise
};

// `quick`: fewer and smaller points. Throws UsageError for names that are none, or stand twice; empty: all.
std::vector<BenchSeries> benchSeries(std::string_view names, bool isQuick);

// What an axis goes by: triangles, pixels and so on.
double sizeOn(std::string_view axis, const BenchPoint& point, std::uint64_t triangles);

} // namespace lixel::app
