// SPDX-License-Identifier: MIT
#include "experiment.h"
#include "experiments/one_picture.h"
#include "lixel/judge/shades.h"
#include "run_results.h"

#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

// Pagot, Comba, Oliveira 2004, Table 1 and Figure 3: a kernel of k taps over n depths has up to nk + 1 outcomes. Here they are counted:
// the different values of visibility in pictures of a scene, all its views with the sun together.
namespace lixel::app {
namespace {

constexpr const char* kScene = "bunnies";
constexpr std::array<const char*, 4> kViews{"overview", "close-up", "grazing", "light-in-front"};
constexpr std::array<int, 5> kTaps{1, 4, 9, 16, 25};
constexpr int kMostDepths = 8;
constexpr double kApart = 1e-5; // of two shades; shares of nk are at least 1/200 apart

// Table 1, rows as kTaps, columns n = 1 to 8.
constexpr int kPaper[5][kMostDepths] = {{2, 3, 4, 5, 6, 7, 8, 9},
                                        {5, 9, 13, 17, 21, 25, 29, 33},
                                        {10, 19, 28, 37, 46, 55, 64, 73},
                                        {17, 33, 49, 65, 81, 97, 113, 129},
                                        {26, 51, 76, 101, 126, 151, 176, 201}};

using Shades = std::array<std::array<std::set<long>, kMostDepths>, kTaps.size()>; // [k][n - 1]

// Figure 3: the paper's four lines, over the samples of the kernel.
ReproducedChart figure3(const Shades& shades)
{
    ReproducedChart chart{"Figure 3: different values of visibility", "samples of the kernel", "seen", {}};
    for (int n = 1; n <= 4; ++n) {
        ReproducedChart::Line& line = chart.lines.emplace_back(fmt::format("n = {}", n));
        for (std::size_t k = 0; k < kTaps.size(); ++k)
            line.points.emplace_back(kTaps[k], double(shades[k][std::size_t(n - 1)].size()));
    }
    return chart;
}

} // namespace

Reproduction reproduceMultipleDepthTable1(const ExperimentOptions& options)
{
    const std::string size = options.isQuick ? "192x192" : "512x512";
    const LixelSize lixels = options.isQuick ? LixelSize{128, 128} : LixelSize{512, 512};
    const std::size_t views = options.isQuick ? 1 : kViews.size();
    const auto executor = makeExecutor(options.executor);
    Shades shades;
    Progress progress("reproduce", int(views * kTaps.size() * kMostDepths));
    for (std::size_t v = 0; v < views; ++v) {
        const OnePicture picture(kScene, kViews[v], size, *executor);
        for (std::size_t k = 0; k < kTaps.size(); ++k)
            for (int n = 1; n <= kMostDepths; ++n) {
                const std::string technique = fmt::format("depths({})+pcf({})", n, kTaps[k]);
                progress.step(fmt::format("{}: {}", kViews[v], technique));
                const FramePlan plan = picture.planOf(technique, lixels, *executor);
                const Visibility visibility = executor->run(picture.stage, plan, picture.samples).front();
                for (std::size_t i = 0; i < picture.samples.size(); ++i)
                    if (picture.truth.zones[0][i] != Zone::FacingAway)
                        shades[k][std::size_t(n - 1)].insert(std::lround(double(visibility.value[i]) / kApart));
            }
    }
    Reproduction out;
    out.run.timing.host = executor->host();
    out.parameters = {{"scene", kScene},
                      {"views", fmt::format("{}", fmt::join(kViews.begin(), kViews.begin() + views, ", "))},
                      {"size", size},
                      {"lixels", toString(lixels)},
                      {"executor", options.executor},
                      {"choice of depths", "n = 2 max, 3 minmax, 4 to 8 sorted, of 3x3 lixels"}};
    for (std::size_t k = 0; k < kTaps.size(); ++k)
        for (std::size_t n = 0; n < kMostDepths; ++n)
            out.numbers.push_back({fmt::format("PCF({},{})", kTaps[k], n + 1), "different shades seen",
                                   double(shades[k][n].size()), double(kPaper[k][n]),
                                   "Table 1, the most there can be"});
    out.charts = {figure3(shades)};
    return out;
}

} // namespace lixel::app
