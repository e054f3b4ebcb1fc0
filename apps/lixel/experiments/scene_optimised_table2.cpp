// SPDX-License-Identifier: MIT
#include "experiments/scene_optimised_loops.h"

#include <fmt/format.h>

// Chong and Gortler 2007, Table 2 and what its text says of times: a frame of Optimal, Focused and LiSPSM, by the number of lights
// and the size of their maps, as ratios to Focused; 1250x1250 optimised against 1750x1750 normal; one bit more for each light.
namespace lixel::app {
namespace {

constexpr int kMostLights = 4;
constexpr std::array<int, 3> kMaps{500, 700, 1000};

struct FramesPerSecond
{
    double optimal, focused, lispsm;
};
constexpr std::array<std::array<FramesPerSecond, kMaps.size()>, kMostLights> kPaper{{
    {{{56.7, 67.3, 69.3}, {55.1, 65.3, 66.7}, {51.9, 60.7, 62.4}}},
    {{{39.3, 44.4, 45.7}, {36.7, 41.7, 43.0}, {33.8, 37.9, 39.4}}},
    {{{29.2, 32.5, 33.3}, {27.1, 30.2, 31.5}, {24.8, 27.1, 28.3}}},
    {{{22.8, 25.2, 25.9}, {21.1, 23.2, 24.2}, {19.4, 21.2, 22.0}}},
}};

// "For 4 lights, an optimized shadow map with resolution 1250x1250 gives similar quality to a normal shadow map of resolution
// 1750x1750 while sacrificing about 1 frame per second (7% of framerate)." Normal maps of this section are focused.
constexpr int kOptimisedMap = 1250, kNormalMap = 1750;
constexpr double kPaperFrameRate = 0.93;
constexpr int kJudgedFrames = 5;

constexpr int kManyLights = 32;

class Table2
{
public:
    explicit Table2(const ExperimentOptions& options) : experiment_(options, 4), progress_("reproduce", steps()) {}
    Reproduction run();

private:
    // Quick: the ends of the table.
    std::vector<int> lights() const { return experiment_.isQuick() ? std::vector{1, 4} : std::vector{1, 2, 3, 4}; }
    std::size_t maps() const { return experiment_.isQuick() ? 1 : kMaps.size(); }
    int steps() const { return int(lights().size() * maps() + 1) * experiment_.stepsOf(4, 0); }

    void addTimes(int lights, std::size_t map);
    void addEqualQuality();
    void addReadback();

    LoopExperiment experiment_;
    Progress progress_;
    std::vector<ReproducedNumber> numbers_, times_;
};

void Table2::addTimes(int lights, std::size_t map)
{
    const LixelSize lixels = experiment_.map(kMaps[map]);
    const std::array<TimedLoop, 4> loops{LoopExperiment::loop(kOptimal, lixels), LoopExperiment::loop(kFocused, lixels),
                                         LoopExperiment::loop(kLispsm, lixels), LoopExperiment::loop(kOurs, lixels)};
    const std::vector<Light> suns = sunsAround(lights);
    const std::vector<LoopTimes> times = experiment_.time(loops, suns, 0, progress_);
    experiment_.judge(loops, times, suns, 1);

    const FramesPerSecond& paper = kPaper[std::size_t(lights - 1)][map];
    const std::string where = fmt::format("{} {}, {}", lights, lights > 1 ? "lights" : "light", toString(lixels));
    const auto add = [&](std::string_view what, const char* unit, double ours, std::optional<double> papers) {
        times_.push_back({fmt::format("{}: {}", where, what), unit, ours, papers, papers ? "Table 2" : ""});
    };
    const auto addRatio = [&](const char* what, const LoopTimes& of, std::optional<double> papers) {
        const TimeRatio ratio = timeRatio(of, times[1]);
        add(fmt::format("{} over focused, mean", what), "ratio of frame times", ratio.mean, papers);
        add(fmt::format("{} over focused, worst frame", what), "ratio of frame times", ratio.worst, std::nullopt);
    };
    addRatio("optimal", times[0], paper.focused / paper.optimal);
    addRatio("ours", times[3], std::nullopt);
    addRatio("lispsm", times[2], paper.focused / paper.lispsm);
    add("focused", "frames per second", 1e3 / mean(times[1].frameMs), paper.focused);
}

void Table2::addEqualQuality()
{
    const LixelSize small = experiment_.map(kOptimisedMap), large = experiment_.map(kNormalMap);
    const std::array<TimedLoop, 4> loops{LoopExperiment::loop(kOptimal, small), LoopExperiment::loop(kFocused, large),
                                         LoopExperiment::loop(kFocused, small), LoopExperiment::loop(kOurs, small)};
    const std::vector<Light> suns = sunsAround(kMostLights);
    const std::vector<LoopTimes> times = experiment_.time(loops, suns, 0, progress_);
    const Judged percent = experiment_.judge(loops, times, suns, kJudgedFrames);
    const std::array<std::string, 4> names{
        fmt::format("optimal {}", toString(small)), fmt::format("focused {}", toString(large)),
        fmt::format("focused {}", toString(small)), fmt::format("ours {}", toString(small))};
    for (std::size_t i = 0; i < names.size(); ++i)
        numbers_.push_back(
            {fmt::format("4 lights: {}, misclassified", names[i]), "percent of samples", percent[i], {}, ""});
    for (const std::size_t i : {std::size_t(0), std::size_t(3)}) {
        const bool isPapers = i == 0;
        const std::string which = fmt::format("4 lights: {} over {}", names[i], names[1]);
        numbers_.push_back({which + ", misclassified", "ratio", percent[i] / percent[1],
                            isPapers ? std::optional(1.0) : std::nullopt,
                            isPapers ? "section 3: similar quality" : ""});
        times_.push_back({which + ", frame rate", "ratio", 1 / timeRatio(times[i], times[1]).mean,
                          isPapers ? std::optional(kPaperFrameRate) : std::nullopt,
                          isPapers ? "section 3: 7 % of framerate" : ""});
    }
}

void Table2::addReadback()
{
    const ReadbackCost one = experiment_.readbackOf(sunsAround(1)),
                       many = experiment_.readbackOf(sunsAround(kManyLights));
    constexpr const char* kSource = "section 2.4: up to 31 additional lights add no extra cost";
    times_.push_back({"readback, 32 lights over 1", "ratio of times", many.readbackMs / one.readbackMs, 1.0, kSource});
    times_.push_back({"sample pass and readback, 32 lights over 1",
                      "ratio of times",
                      (many.sampleMs + many.readbackMs) / (one.sampleMs + one.readbackMs),
                      {},
                      ""});
    times_.push_back({"sample pass and readback, 1 light", "ms", one.sampleMs + one.readbackMs, {}, ""});
}

Reproduction Table2::run()
{
    for (const int count : lights())
        for (std::size_t map = 0; map < maps(); ++map) addTimes(count, map);
    addEqualQuality();
    addReadback();
    Reproduction out = experiment_.finished();
    out.parameters.insert(out.parameters.end(), {{"optimal", kOptimal}, {"ours", kOurs}});
    out.numbers = std::move(numbers_);
    out.timingNumbers = std::move(times_);
    return out;
}

} // namespace

Reproduction reproduceSceneOptimisedTable2(const ExperimentOptions& options) { return Table2(options).run(); }

} // namespace lixel::app
