// SPDX-License-Identifier: MIT
#include "bench/bench_axes.h"

#include "exit_code.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace lixel::app {
namespace {

struct Axis
{
    const char *name, *unit;
    int BenchPoint::*varied;
    std::vector<int> values, quickValues;
};

const std::array<Axis, 4>& allAxes()
{
    static const std::array<Axis, 4> kAll{{
        {"triangles",
         "triangles of the scene",
         &BenchPoint::triangles,
         {1'000, 3'000, 10'000, 30'000, 100'000, 300'000, 1'000'000, 3'000'000, 10'000'000},
         {1'000, 10'000, 100'000, 300'000}},
        {"pixels", "pixels of the picture", &BenchPoint::side, {256, 512, 1024, 2048, 4096}, {128, 256, 512}},
        {"lixels",
         "lixels of a light",
         &BenchPoint::mapSide,
         {128, 256, 512, 1024, 2048, 4096, 8192},
         {128, 256, 512, 1024}},
        {"lights", "lights of the picture", &BenchPoint::lights, {1, 2, 4, 8, 16, 32}, {1, 2, 4}},
    }};
    return kAll;
}

constexpr BenchPoint kQuickPoint{30'000, 256, 512, 1};

// What the axis does not vary.
std::string othersOf(const Axis& axis, const BenchPoint& point)
{
    std::string text;
    const auto add = [&](int BenchPoint::*member, const std::string& what) {
        if (member != axis.varied) text += (text.empty() ? "" : ", ") + what;
    };
    add(&BenchPoint::triangles, fmt::format("{} triangles", point.triangles));
    add(&BenchPoint::side, fmt::format("{0}x{0} pixels", point.side));
    add(&BenchPoint::mapSide, fmt::format("{0}x{0} lixels a light", point.mapSide));
    add(&BenchPoint::lights, fmt::format("{} light", point.lights));
    return text;
}

BenchSeries seriesOf(const Axis& axis, bool isQuick)
{
    const BenchPoint usual = isQuick ? kQuickPoint : BenchPoint();
    BenchSeries series{{axis.name, axis.unit, othersOf(axis, usual)}, {}};
    for (const int value : isQuick ? axis.quickValues : axis.values) {
        BenchPoint& point = series.points.emplace_back(usual);
        point.*axis.varied = value;
    }
    return series;
}

} // namespace

std::string BenchPoint::scene() const { return fmt::format("balls(triangles={})", triangles); }

std::vector<BenchSeries> benchSeries(std::string_view names, bool isQuick)
{
    std::vector<BenchSeries> out;
    if (names.empty())
        for (const Axis& axis : allAxes()) out.push_back(seriesOf(axis, isQuick));
    while (!names.empty()) {
        const std::string_view name = names.substr(0, names.find(','));
        names.remove_prefix(std::min(names.size(), name.size() + 1));
        const auto axis = std::ranges::find(allAxes(), name, [](const Axis& a) { return std::string_view(a.name); });
        if (axis == allAxes().end())
            throw UsageError(fmt::format("--axes \"{}\": expected triangles, pixels, lixels or lights", name));
        for (const BenchSeries& other : out)
            if (other.axis.name == name) throw UsageError(fmt::format("--axes: \"{}\" stands there twice", name));
        out.push_back(seriesOf(*axis, isQuick));
    }
    return out;
}

double sizeOn(std::string_view axis, const BenchPoint& point, std::uint64_t triangles)
{
    if (axis == "triangles") return double(triangles);
    if (axis == "pixels") return double(point.side) * point.side;
    if (axis == "lixels") return double(point.mapSide) * point.mapSide;
    return point.lights;
}

} // namespace lixel::app
