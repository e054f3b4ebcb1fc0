// SPDX-License-Identifier: MIT
#include "experiment.h"
#include "experiments/enlarged_square.h"
#include "experiments/one_picture.h"
#include "lixel/judge/shades.h"
#include "lixel/plan/lookup/lookup.h"
#include "lixel/report/png.h"
#include "lixel/trace/exact_filtered.h"
#include "run_results.h"
#include "shade_quality.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

// Pagot, Comba, Oliveira 2004, Figures 1, 6 and 7: pictures and maps of 512x512, the same shadows by kernels of different sizes over one
// to three depths. The paper shows them side by side; here they are also held against the two truths that a partial shadow may stand
// for, on planar receivers (the scene's floor and wall) and on curved ones (all others). The paper's scenes are not to be had.
namespace lixel::app {
namespace {

constexpr const char* kScene = "bunnies";
constexpr int kRays = 8; // a side of a filter's footprint

// PCF(16,1), every rule of choosing depths with the 3x3 kernel, then the paper's other pictures, and what is not filtered at all.
constexpr std::array<const char*, 19> kTechniques{"pcf(16)",
                                                  "pcf(9)",
                                                  "depths(2,max)+pcf(9)",
                                                  "depths(2,min)+pcf(9)",
                                                  "depths(3)+pcf(9)",
                                                  "depths(4)+pcf(9)",
                                                  "depths(5)+pcf(9)",
                                                  "depths(8)+pcf(9)",
                                                  "depths(2,max,q=25)+pcf(9)",
                                                  "depths(2,min,q=25)+pcf(9)",
                                                  "depths(3,q=25)+pcf(9)",
                                                  "depths(4,q=25)+pcf(9)",
                                                  "depths(8,q=25)+pcf(9)",
                                                  "depths(4,bits=16)+pcf(9)",
                                                  "depths(3)+pcf(4)",
                                                  "pcf(4)",
                                                  "depths(4)+pcf(4)",
                                                  "pcf(1)",
                                                  "depths(3)"};
constexpr const char* kNine = "pcf(9)"; // PCF(9,1), which smaller kernels are held against

struct Figure
{
    const char* title;
    const char* view;
    std::vector<std::string> techniques;
};
const std::array<Figure, 3> kFigures{{{"Figure 1: PCF(16,1), PCF(9,2) and PCF(9,3)",
                                       "overview",
                                       {"pcf(16)", "depths(2,max)+pcf(9)", "depths(3)+pcf(9)", "exact"}},
                                      {"Figure 6, planar receivers: PCF(9,1), PCF(16,1), PCF(4,3) and PCF(9,3)",
                                       "grazing",
                                       {"pcf(9)", "pcf(16)", "depths(3)+pcf(4)", "depths(3)+pcf(9)"}},
                                      {"Figure 7, curved receivers: PCF(16,1), PCF(9,2) and PCF(9,3)",
                                       "close-up",
                                       {"pcf(16)", "depths(2,max)+pcf(9)", "depths(3)+pcf(9)", "exact"}}}};

// Over samples of the edge band of all figures.
struct Errors
{
    ShadeError area, own, classic; // against the pixel, the own kernel's footprint, and that of PCF(16,1)
    ShadeError nine;               // of kernels of 2x2 taps: against the footprint of PCF(9,1)

    static void add(ShadeError& to, const ShadeError& one)
    {
        to.samples += one.samples;
        to.sumOfSquares += one.sumOfSquares;
        to.largest = std::max(to.largest, one.largest);
    }
};
enum Receivers : std::size_t { Planar, Curved };
constexpr std::array<const char*, 2> kReceivers{"planar", "curved"};

class Figures
{
public:
    explicit Figures(const ExperimentOptions& options)
        : options_(options),
          size_(options.isQuick ? "160x160" : "512x512"),
          lixels_(options.isQuick ? LixelSize{160, 160} : LixelSize{512, 512}),
          progress_("reproduce", int(kFigures.size() * 2 * kTechniques.size()))
    {
        executors_.push_back(makeExecutor(options.executor));
    }
    Reproduction run();

private:
    void measure(const OnePicture& picture, const PartialTruth& band);
    void addRows(OnePicture& picture, const Figure& figure);
    void addNumbers();
    void addAgainstNine();
    void addTransitions(const Figure& figure, std::span<const ResultRow> rows);

    const ExperimentOptions& options_;
    std::string size_;
    LixelSize lixels_;
    std::vector<std::unique_ptr<Executor>> executors_;
    Progress progress_;
    std::array<std::array<Errors, kTechniques.size()>, 2> errors_;
    Reproduction out_;
};

// Of the samples on planes and off them, by each technique.
void Figures::measure(const OnePicture& picture, const PartialTruth& band)
{
    const Light& light = picture.shot().lights.front();
    for (std::size_t t = 0; t < kTechniques.size(); ++t) {
        progress_.step(fmt::format("{}: {}", picture.shot().name, kTechniques[t]));
        const FramePlan plan = picture.planOf(kTechniques[t], lixels_, *executors_.front());
        const std::vector<float> all = executors_.front()->run(picture.stage, plan, picture.samples).front().value;
        const std::vector<float> values = valuesOf(all, band.band);
        const auto filtered = [&](double side) {
            return exactFiltered(*picture.stage.traced, plan.lights.front(), band.samples, light, {side}, kRays);
        };
        const double side = filterOf(plan.lookup).side;
        const std::vector<float> own = filtered(side), classic = filtered(4),
                                 nine = side == 2 ? filtered(3) : std::vector<float>{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto against = [&](float truth) { return shadeError({&values[i], 1}, {&truth, 1}); };
            Errors& errors = errors_[picture.truth.plane[band.band[i]] == kOnNoPlane ? Curved : Planar][t];
            Errors::add(errors.area, against(band.area[i]));
            Errors::add(errors.own, against(own[i]));
            Errors::add(errors.classic, against(classic[i]));
            if (!nine.empty()) Errors::add(errors.nine, against(nine[i]));
        }
    }
}

void Figures::addRows(OnePicture& picture, const Figure& figure)
{
    ComparisonOptions comparison;
    std::string list;
    for (const char* technique : kTechniques) list += std::string(list.empty() ? "" : ",") + technique;
    comparison.techniques = readTechniques(list + ",exact");
    comparison.lixels.total = lixels_;
    comparison.timingFrames = 3;
    comparison.pictures = options_.pictures;
    std::vector<ResultRow> rows = compareTechniques(
        {picture.shooting, picture.shot(), picture.stage, picture.view, picture.samples, picture.truth, comparison},
        executors_, [&](std::string_view now) { progress_.step(now); });
    addTransitions(figure, rows);
    PictureRow shown{figure.title, rows.front().scene, rows.front().view, rows.front().light, figure.techniques};
    for (ResultRow& row : rows) {
        const Measurement* m = row.measured();
        if (m && row.technique == "pcf(9)" && !m->pictures.error.empty())
            enlargeWhereMostIsWrong(readPng(options_.pictures / m->pictures.error), picture.samples,
                                    picture.truth.plane, shown);
        row.seed = options_.seed;
        out_.run.rows.push_back(std::move(row));
    }
    if (!options_.pictures.empty()) out_.figures.push_back(std::move(shown));
}

// How much of the picture lies between lit and dark, of the techniques that a figure shows.
void Figures::addTransitions(const Figure& figure, std::span<const ResultRow> rows)
{
    const auto widthOf = [&](std::string_view technique) {
        for (const ResultRow& row : rows)
            if (row.technique == technique && row.measured() && row.measured()->shades)
                return row.measured()->shades->transitionPixels;
        return 0.0;
    };
    const double classic = widthOf(kTechniques.front());
    for (const std::string& technique : figure.techniques)
        if (technique != kTechniques.front() && technique != "exact" && classic > 0)
            out_.numbers.push_back(
                {fmt::format("{}, {}: width of the transition over that of PCF(16,1)", figure.view, technique),
                 "ratio of widths in pixels",
                 widthOf(technique) / classic,
                 {},
                 ""});
}

// Figure 6 has a kernel of 2x2 taps beside PCF(9,1).
void Figures::addAgainstNine()
{
    const auto nine = std::size_t(std::ranges::find(kTechniques, std::string_view(kNine)) - kTechniques.begin());
    for (const std::size_t r : {Planar, Curved})
        for (std::size_t t = 0; t < kTechniques.size(); ++t)
            if (const ShadeError& error = errors_[r][t].nine; error.samples > 0)
                out_.numbers.push_back(
                    {fmt::format("{}, {}: RMSE over that of PCF(9,1), against the 3x3 footprint of PCF(9,1)",
                                 kReceivers[r], kTechniques[t]),
                     "ratio",
                     error.rootMeanSquare() / errors_[r][nine].own.rootMeanSquare(),
                     {},
                     ""});
}

// PCF(16,1) comes first: the others are so much more than it.
void Figures::addNumbers()
{
    struct Against
    {
        const char* truth;
        ShadeError Errors::*error;
    };
    constexpr std::array<Against, 3> kTruths{{{"the 4x4 footprint of PCF(16,1)", &Errors::classic},
                                              {"its own footprint", &Errors::own},
                                              {"the pixel's area", &Errors::area}}};
    ReproducedTable table{"Error over the edge band", "RMSE of visibility", "which gives none", {}, {}};
    ReproducedTable largest{
        "Largest error over the edge band", "largest difference of visibility", "which gives none", {}, {}};
    for (const char* technique : kTechniques) table.columns.push_back({technique, technique});
    largest.columns = table.columns;
    for (const std::size_t r : {Planar, Curved})
        for (const Against& against : kTruths) {
            ReproducedTable::Row row{fmt::format("{} receivers, against {}", kReceivers[r], against.truth), {}};
            ReproducedTable::Row most{fmt::format("{} receivers, largest against {}", kReceivers[r], against.truth),
                                      {}};
            for (const Errors& errors : errors_[r]) {
                row.cells.push_back({(errors.*against.error).rootMeanSquare(), {}});
                most.cells.push_back({(errors.*against.error).largest, {}});
            }
            for (std::size_t t = 1; t < kTechniques.size() && against.error != &Errors::area; ++t)
                out_.numbers.push_back({fmt::format("{}, {}: RMSE over that of PCF(16,1), against {}", kReceivers[r],
                                                    kTechniques[t], against.truth),
                                        "ratio",
                                        row.cells[t].ours / row.cells.front().ours,
                                        {},
                                        ""});
            table.rows.push_back(std::move(row));
            largest.rows.push_back(std::move(most));
        }
    out_.tables.push_back(std::move(table));
    out_.tables.push_back(std::move(largest));
}

Reproduction Figures::run()
{
    for (const Figure& figure : kFigures) {
        OnePicture picture(kScene, figure.view, size_, *executors_.front());
        picture.truth.partial =
            findPartialTruth(picture.stage, picture.view, picture.samples, picture.shot().lights, picture.truth);
        measure(picture, picture.truth.partial.front());
        addRows(picture, figure);
    }
    addNumbers();
    addAgainstNine();
    out_.run.timing.host = executors_.front()->host();
    out_.parameters = {{"scene", kScene},
                       {"size", size_},
                       {"lixels", toString(lixels_)},
                       {"executor", options_.executor},
                       {"planar receivers", "the scene's floor and wall"}};
    return std::move(out_);
}

} // namespace

Reproduction reproduceMultipleDepthFigures(const ExperimentOptions& options) { return Figures(options).run(); }

} // namespace lixel::app
