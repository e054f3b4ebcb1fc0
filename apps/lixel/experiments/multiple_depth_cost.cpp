// SPDX-License-Identifier: MIT
#include "experiment.h"
#include "experiments/one_picture.h"
#include "run_results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

// Pagot, Comba, Oliveira 2004, sections 4.1 and 6: what filtering costs. The paper counts texture accesses,
//
//   (1) cost_sm = f (transf + k (texture + st))       (3) cost_scene = f k
//   (2) cost_2value = q h w                           (4) cost_2sm_scene = q h w + f k
//   (5) PCF(k,2) is cheaper than PCF(k+r,1) when f > q h w / r         (6) deferred: lambda_h lambda_w > q / r
//
// with q = 9, k = 9, r = 7. Here the terms are measured: lookup passes of pictures of many sizes against maps of 512x512, a straight
// line through their times over k for each n, and the pass that chooses depths.
namespace lixel::app {
namespace {

constexpr const char* kScene = "bunnies";
constexpr const char* kView = "overview";
constexpr int kMap = 512;
constexpr std::array<int, 5> kTaps{1, 4, 9, 16, 25};
constexpr double kQ = 9, kR = 16 - 9;
constexpr int kRounds = 9, kQuickRounds = 3; // of all that is compared, in turns

// Section 6: the resolution from which on the deferred method pays, and the factor of the number of fragments.
constexpr double kPaperSide = 656, kPaperFactor = 1.28;

struct PassMs
{
    double prepare = 0, lookup = 0;
};

struct Line // ms = at + perTap k
{
    double at = 0, perTap = 0;
};

Line lineThrough(const std::array<double, kTaps.size()>& ms)
{
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < kTaps.size(); ++i) {
        const double k = kTaps[i];
        n += 1, x += k, y += ms[i], xx += k * k, xy += k * ms[i];
    }
    const double perTap = (n * xy - x * y) / (n * xx - x * x);
    return {(y - perTap * x) / n, perTap};
}

double farthestFrom(const Line& line, const std::array<double, kTaps.size()>& ms)
{
    double farthest = 0;
    for (std::size_t i = 0; i < kTaps.size(); ++i)
        farthest = std::max(farthest, std::abs(ms[i] - line.at - line.perTap * kTaps[i]));
    return farthest;
}

// Equation 6, of a picture with so many fragments a pixel: lambda from which on there are so many of them a lixel.
double sidesAt(double fragmentsPerLixel, double fragmentsPerPixel)
{
    return std::sqrt(fragmentsPerLixel / fragmentsPerPixel);
}

// A lookup of a picture.
struct Timed
{
    const OnePicture* picture;
    std::string technique;
};

class Cost
{
public:
    explicit Cost(const ExperimentOptions& options)
        : options_(options),
          executor_(makeExecutor(options.executor)),
          sides_(options.isQuick ? std::vector<int>{256, 512, 768}
                                 : std::vector<int>{256, 384, 512, 640, 768, 1024, 1280, 1536, 1792})
    {
    }
    Reproduction run();

private:
    std::vector<PassMs> timesOf(std::span<const Timed> all);
    void addTerms(const OnePicture& picture);
    void addBreakEven();
    void addFragments();
    void add(const std::string& key, const char* unit, double ours)
    {
        out_.timingNumbers.push_back({key, unit, ours, {}, ""});
    }

    const ExperimentOptions& options_;
    std::unique_ptr<Executor> executor_;
    std::vector<int> sides_;
    double samplesShare_ = 0; // of pixels that see a surface
    Line one_, two_;          // ms a sample
    double prepare_ = 0;      // ms of the map
    double predicted_ = 0;    // fragments a lixel; below 0: never
    Reproduction out_;
};

// The least times of passes in rounds of all that is compared: what else the machine does then falls on all of it alike.
std::vector<PassMs> Cost::timesOf(std::span<const Timed> all)
{
    std::vector<FramePlan> plans;
    for (const Timed& one : all) plans.push_back(one.picture->planOf(one.technique, {kMap, kMap}, *executor_));
    std::vector<PassMs> least(plans.size(), {1e30, 1e30});
    for (int round = 0; round < (options_.isQuick ? kQuickRounds : kRounds); ++round)
        for (std::size_t i = 0; i < plans.size(); ++i) {
            PassMs now;
            const OnePicture& picture = *all[i].picture;
            for (const PassTime& pass : executor_->time(picture.stage, plans[i], picture.view, 1).passes) {
                if (pass.name == "prepare") now.prepare = pass.ms;
                if (pass.name == "lookup") now.lookup = pass.ms;
            }
            least[i] = {std::min(least[i].prepare, now.prepare), std::min(least[i].lookup, now.lookup)};
        }
    return least;
}

// Equation 1 by n, and equation 2, in nanoseconds.
void Cost::addTerms(const OnePicture& picture)
{
    const double samples = double(picture.samples.size());
    samplesShare_ = samples / (double(picture.view.width) * picture.view.height);
    constexpr std::array kAllDepths{1, 2, 4, 3, 8};
    const std::span depths = std::span(kAllDepths).first(options_.isQuick ? 3 : kAllDepths.size());
    std::vector<Timed> all;
    for (const int n : depths)
        for (const int k : kTaps) all.push_back({&picture, fmt::format("depths({})+pcf({})", n, k)});
    const std::vector<PassMs> times = timesOf(all);
    for (std::size_t at = 0; at < depths.size(); ++at) {
        const int n = depths[at];
        std::array<double, kTaps.size()> ms{};
        double prepare = 1e30;
        for (std::size_t i = 0; i < kTaps.size(); ++i) {
            const PassMs& pass = times[at * kTaps.size() + i];
            ms[i] = pass.lookup;
            prepare = std::min(prepare, pass.prepare);
        }
        const Line line = lineThrough(ms);
        add(fmt::format("equation 1, n = {}: transf, a sample", n), "ns", 1e6 * line.at / samples);
        add(fmt::format("equation 1, n = {}: texture + st, a tap of a sample", n), "ns", 1e6 * line.perTap / samples);
        if (n > 1)
            add(fmt::format("equation 2, n = {}: choosing depths, a lixel and neighbour", n), "ns",
                1e6 * prepare / (kQ * kMap * kMap));
        if (n == 1) one_ = {line.at / samples, line.perTap / samples};
        if (n == 2) two_ = {line.at / samples, line.perTap / samples}, prepare_ = prepare;
        if (n == 1)
            add("equation 1, n = 1: farthest of a time from the line", "percent of the time of 25 taps",
                100 * farthestFrom(line, ms) / ms.back());
    }
    const double one = one_.at + 9 * one_.perTap, two = two_.at + 9 * two_.perTap;
    add("nine taps of two depths over nine of one", "ratio of times", two / one);
    add("nine taps of two depths, chosen anew, over nine of one", "ratio of times, lambda 2",
        (two + prepare_ / (samplesShare_ * 4 * kMap * kMap)) / one);
}

// Where PCF(9,2) with its preparation overtakes PCF(16,1), by the terms and by whole measurements at growing pictures.
void Cost::addBreakEven()
{
    const double gain = one_.at + 16 * one_.perTap - two_.at - 9 * two_.perTap; // ms a sample
    predicted_ = prepare_ / gain / (double(kMap) * kMap);
    add("predicted break-even, f / (h w)", "fragments a lixel; below 0: never", predicted_);
    if (predicted_ > 0)
        add("predicted break-even, lambda", "sides, deferred shading of this view", sidesAt(predicted_, samplesShare_));
    ReproducedChart chart{"Lookups of growing pictures",
                          "lambda, the picture's side over the map's",
                          "ms",
                          {{"PCF(16,1)", {}}, {"PCF(9,2) and its depths", {}}, {"PCF(9,2) of maps that are kept", {}}},
                          true};
    std::optional<double> crossing;
    double before = 0, beforeF = 0, fastest = 0, slowest = 0;
    std::deque<OnePicture> pictures;
    std::vector<Timed> all;
    for (const int side : sides_) {
        pictures.emplace_back(kScene, kView, fmt::format("{}x{}", side, side), *executor_);
        for (const char* technique : {"pcf(16)", "depths(2,max)+pcf(9)"}) all.push_back({&pictures.back(), technique});
    }
    const std::vector<PassMs> times = timesOf(all);
    for (std::size_t s = 0; s < sides_.size(); ++s) {
        const PassMs classic = times[2 * s], multiple = times[2 * s + 1];
        const double f = double(pictures[s].samples.size()) / (double(kMap) * kMap);
        const double lambda = double(sides_[s]) / kMap, fresh = multiple.prepare + multiple.lookup;
        const double more = fresh - classic.lookup;
        const std::array ms{classic.lookup, fresh, multiple.lookup};
        for (std::size_t i = 0; i < ms.size(); ++i) {
            chart.lines[i].points.emplace_back(lambda, ms[i]);
            add(fmt::format("lambda {:.3f}: {}", lambda, chart.lines[i].label), "ms", ms[i]);
        }
        if (!crossing && more < 0 && beforeF > 0) crossing = beforeF + (f - beforeF) * before / (before - more);
        if (!crossing && more < 0 && beforeF == 0) crossing = f;
        before = more, beforeF = f;
        fastest = fastest > 0 ? std::min(fastest, multiple.prepare) : multiple.prepare;
        slowest = std::max(slowest, multiple.prepare);
    }
    out_.charts = {std::move(chart)};
    add("choosing depths, the slowest picture over the fastest", "ratio of times", slowest / fastest);
    if (!crossing) return;
    add("measured break-even, f / (h w)", "fragments a lixel", *crossing);
    add("measured break-even, lambda", "sides, deferred shading of this view", sidesAt(*crossing, samplesShare_));
}

// Fragments of a forward renderer without a depth test, a pixel: what f is for scenes. lixel shades deferred, so what a fragment costs
// there is taken from the terms of a sample.
void Cost::addFragments()
{
    constexpr std::array kScenes{"bunnies", "city", "table", "objects", "colonnade", "fence", "lamp"};
    for (const char* scene : std::span(kScenes).first(options_.isQuick ? 2 : kScenes.size())) {
        const OnePicture picture(scene, "", "256x256", *executor_);
        const double pixels = double(picture.view.width) * picture.view.height;
        const double fragments = double(fragmentsOf(picture.stage, picture.view)) / pixels;
        const std::string shot = fmt::format("{}, {}", scene, picture.shot().name);
        out_.numbers.push_back({shot + ": fragments a pixel, forward", "ratio", fragments, {}, ""});
        out_.numbers.push_back(
            {shot + ": break-even by accesses, lambda, forward", "sides", sidesAt(kQ / kR, fragments), {}, ""});
        if (predicted_ > 0)
            add(shot + ": predicted break-even, lambda, forward", "sides", sidesAt(predicted_, fragments));
    }
}

Reproduction Cost::run()
{
    out_.numbers = {
        {"equation 5: f over the lixels of the map", "ratio, in accesses", kQ / kR, kPaperFactor, "section 6"},
        {"equation 6: side of a square screen over a map of 512", "pixels, in accesses", kMap * std::sqrt(kQ / kR),
         kPaperSide, "section 6; 1.28 is the ratio of areas, the paper has taken it for that of sides"}};
    {
        const OnePicture picture(kScene, kView, options_.isQuick ? "256x256" : "1024x1024", *executor_);
        addTerms(picture);
    }
    addBreakEven();
    addFragments();
    out_.run.timing.host = executor_->host();
    out_.parameters = {{"scene", kScene},
                       {"view", kView},
                       {"lixels", toString(LixelSize{kMap, kMap})},
                       {"pixels that see a surface", fmt::format("{:.1f} %", 100 * samplesShare_)},
                       {"executor", options_.executor}};
    return std::move(out_);
}

} // namespace

Reproduction reproduceMultipleDepthCost(const ExperimentOptions& options) { return Cost(options).run(); }

} // namespace lixel::app
