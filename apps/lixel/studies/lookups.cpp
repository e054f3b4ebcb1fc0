// SPDX-License-Identifier: MIT
#include "lixel/report/lookups.h"

#include "comparison.h"
#include "finish_study.h"
#include "lixel/base/median.h"
#include "lixel/judge/best_front.h"
#include "lixel/plan/lookup/lookup.h"
#include "run_results.h"
#include "shade_quality.h"
#include "studies/lookup_times.h"
#include "study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

// Every store and kernel over the same fit in all views of the built-in scenes: errors against bytes a lixel and against the time of a
// frame, and which lookups no other beats. Errors are counts and so the same every time; times are ratios of frames that take turns.
namespace lixel::app {
namespace {

// The first is what the others are ratios of.
constexpr const char* kLookups =
    "pcf(1),bilinear,dual-plane,bilinear+dual-plane,hardware-pcf,"
    "pcf(4),pcf(9),pcf(16),pcf(25),pcf(9)+dual-plane,pcf(9,rotated),pcf(9,jittered),"
    "depths(2,max),depths(2,min),depths(3),depths(4),depths(4,bits=16),depths(5),depths(6),"
    "depths(8),depths(3)+bilinear,depths(3)+pcf(4),depths(4)+pcf(4),depths(8)+pcf(4),"
    "depths(2,max)+pcf(9),depths(3)+pcf(9),depths(4)+pcf(9),depths(4,bits=16)+pcf(9),"
    "depths(8)+pcf(9),fast-pcf,fast-pcf+pcf(4),fast-pcf+pcf(9),"
    "vsm,evsm2,evsm4,msm,vsm(5),evsm4(5),msm(5)";

struct Sizes
{
    const char* picture;
    LixelSize lixels;
    std::size_t views;    // of a scene, at most
    std::size_t bandStep; // partial truth is of one sample of the edge band in so many
    int filterRays;       // a side of a filter's footprint
};
constexpr Sizes kSizes{"512x512", {256, 256}, 1 << 20, 4, 8};
constexpr Sizes kQuickSizes{"128x128", {64, 64}, 1, 4, 4};
constexpr std::size_t kFootprintStep = 64; // which the study does not ask about

using Place = std::tuple<std::string, std::string, std::string>; // scene, view, light
Place placeOf(const ResultRow& row) { return {row.scene, row.view, row.light}; }

std::vector<Shooting> shootingsOf(const Sizes& sizes, int count)
{
    const std::size_t most = count > 0 ? std::size_t(count) : sizes.views;
    std::vector<Shooting> out;
    for (const char* scene : {"bunnies", "table", "objects", "colonnade", "fence", "city", "lamp"}) {
        PictureOptions picture;
        picture.scene = scene;
        picture.size = sizes.picture;
        Shooting& shooting = out.emplace_back(prepare(picture, true));
        if (shooting.shots.size() > most) shooting.shots.resize(most);
    }
    return out;
}

std::vector<ResultRow> rowsOfShot(const StudiedPicture& picture, const Shot& shot, const Sizes& sizes,
                                  std::span<const std::unique_ptr<Executor>> executors, Progress& progress)
{
    Truth truth = findTruth(picture.stage, picture.samples, shot.lights, picture.shooting.planes);
    truth.partial = findPartialTruth(picture.stage, picture.view, picture.samples, shot.lights, truth, sizes.bandStep);
    ComparisonOptions options;
    options.techniques = readTechniques(kLookups);
    options.lixels.total = sizes.lixels;
    options.timingFrames = 0;
    options.footprintStep = kFootprintStep;
    options.filterRays = sizes.filterRays;
    return compareTechniques({picture.shooting, shot, picture.stage, picture.view, picture.samples, truth, options},
                             executors, [&](std::string_view now) { progress.step(now); });
}

// One lookup's rows added up.
class Sum
{
public:
    void add(const Measurement& m, const Measurement& nearest)
    {
        const ShadeQuality& shades = *m.shades;
        ++out_.lights;
        out_.misclassified += m.misclassified;
        out_.misclassifiedPercent += 100.0 * double(m.misclassified) / double(m.lightFacing);
        out_.shades = std::max(out_.shades, shades.distinct);
        transitions_.push_back(shades.transitionPixels);
        out_.darkInterior.samples += shades.darkInterior.samples;
        out_.darkInterior.misclassified += shades.darkInterior.misclassified;
        out_.bleedingPercent += shades.bleedingPercent * double(shades.darkInterior.samples);
        out_.areaRmse += shades.area.rmse * shades.area.rmse;
        out_.areaLargest = std::max(out_.areaLargest, shades.area.largest);
        out_.filterLixels = shades.filterLixels;
        if (shades.filtered) {
            filteredSquares_ += shades.filtered->rmse * shades.filtered->rmse;
            out_.filteredLargest = std::max(out_.filteredLargest.value_or(0), shades.filtered->largest);
        }
        if (nearest.misclassified == 0) return;
        logRatios_ += std::log(double(std::max<std::int64_t>(m.misclassified, 1)) / double(nearest.misclassified));
        ++ratios_;
    }

    LookupStudy::Lookup mean() const
    {
        LookupStudy::Lookup out = out_;
        const double n = std::max(out.lights, 1);
        out.misclassifiedPercent /= n;
        out.transitionPixels = transitions_.empty() ? 0 : median(transitions_);
        out.bleedingPercent /= double(std::max<std::int64_t>(out.darkInterior.samples, 1));
        out.areaRmse = std::sqrt(out.areaRmse / n);
        if (out.filterLixels) out.filteredRmse = std::sqrt(filteredSquares_ / n);
        out.ratioToNearest = ratios_ > 0 ? std::exp(logRatios_ / ratios_) : 1;
        return out;
    }

private:
    LookupStudy::Lookup out_;
    std::vector<double> transitions_;
    double filteredSquares_ = 0, logRatios_ = 0;
    int ratios_ = 0;
};

// Over the views and lights that none is refused for and that show something in the light.
void addUp(std::span<const TechniqueChoice> choices, LookupStudy& study)
{
    std::set<Place> refused;
    std::map<Place, const Measurement*> nearest;
    for (const ResultRow& row : study.run.rows) {
        if (row.refused() || row.measured()->lightFacing == 0) refused.insert(placeOf(row));
        else if (row.technique == choices.front().typed) nearest[placeOf(row)] = row.measured();
    }
    study.leftOut = int(refused.size());
    std::map<std::string, Sum> sums;
    for (const ResultRow& row : study.run.rows)
        if (!refused.contains(placeOf(row))) sums[row.technique].add(*row.measured(), *nearest.at(placeOf(row)));
    for (const TechniqueChoice& choice : choices) {
        LookupStudy::Lookup& lookup = study.lookups.emplace_back(sums[choice.typed].mean());
        const LookupLayout layout = lookupLayout(std::get<MapTechnique>(choice.technique));
        lookup.lookup = choice.typed;
        lookup.techniqueFull = toString(choice.technique);
        lookup.bytesPerLixel = layout.bytesPerLixel;
        lookup.bytesReadPerLixel = layout.bytesReadPerLixel;
    }
}

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

struct Column
{
    const char* name;
    double (*value)(const LookupStudy::Lookup&);
};
constexpr std::array<Column, 4> kErrors{
    {{"misclassified_percent", [](const LookupStudy::Lookup& l) { return l.misclassifiedPercent; }},
     {"area_rmse", [](const LookupStudy::Lookup& l) { return l.areaRmse; }},
     {"filtered_rmse", [](const LookupStudy::Lookup& l) { return l.filteredRmse.value_or(kNothing); }},
     {"bleeding_percent", [](const LookupStudy::Lookup& l) { return l.bleedingPercent; }}}};
constexpr Column kBytes{"bytes_per_lixel", [](const LookupStudy::Lookup& l) { return double(l.bytesPerLixel); }};
constexpr Column kTime{"frame_ratio",
                       [](const LookupStudy::Lookup& l) { return l.times ? l.times->frameRatio : kNothing; }};

std::vector<LookupStudy::Front> frontsAgainst(const Column& cost, std::span<const LookupStudy::Lookup> lookups)
{
    std::vector<LookupStudy::Front> fronts;
    for (const Column& error : kErrors) {
        std::vector<double> costs, errors;
        for (const LookupStudy::Lookup& lookup : lookups) {
            costs.push_back(cost.value(lookup));
            errors.push_back(error.value(lookup));
        }
        LookupStudy::Front& front = fronts.emplace_back(LookupStudy::Front{error.name, cost.name, {}});
        for (const std::size_t i : bestFront(costs, errors)) front.lookups.push_back(lookups[i].lookup);
    }
    return fronts;
}

void print(const LookupStudy& study, std::FILE* to)
{
    fmt::print(to, "{:<26} {:>5} {:>5} {:>10} {:>8} {:>7} {:>10} {:>9} {:>9} {:>9} {:>9} {:>7} {:>7}\n", "lookup",
               "bytes", "read", "wrong %", "nearest", "shades", "transition", "area", "filtered", "bleeding",
               "lit in %", "frame", "passes");
    for (const LookupStudy::Lookup& l : study.lookups) {
        const auto number = [](const std::optional<double>& value, int digits) {
            return value ? fmt::format("{:.{}f}", *value, digits) : std::string();
        };
        const auto time = [&](double LookupStudy::Times::*which) {
            return l.times ? number((*l.times).*which, 3) : std::string();
        };
        const double inside =
            100.0 * double(l.darkInterior.misclassified) / double(std::max<std::int64_t>(l.darkInterior.samples, 1));
        fmt::print(
            to, "{:<26} {:>5} {:>5} {:>10.4f} {:>8.3f} {:>7} {:>10.2f} {:>9.4f} {:>9} {:>9.4f} {:>9.4f} {:>7} {:>7}\n",
            l.lookup, l.bytesPerLixel, l.bytesReadPerLixel, l.misclassifiedPercent, l.ratioToNearest, l.shades,
            l.transitionPixels, l.areaRmse, number(l.filteredRmse, 4), l.bleedingPercent, inside,
            time(&LookupStudy::Times::frameRatio), time(&LookupStudy::Times::passRatio));
    }
    fmt::print(to, "\nbest, from the cheapest on\n");
    for (const auto& fronts : {study.fronts, study.frontsOfTimes})
        for (const auto& [error, cost, lookups] : fronts)
            fmt::print(to, "  {} against {}: {}\n", error, cost, fmt::join(lookups, ", "));
}

} // namespace

int studyLookups(const StudyOptions& options)
{
    const Sizes& sizes = options.isQuick ? kQuickSizes : kSizes;
    const std::vector<Shooting> shootings = shootingsOf(sizes, options.count);
    const std::vector<TechniqueChoice> choices = readTechniques(kLookups);
    std::vector<std::unique_ptr<Executor>> executors;
    executors.push_back(makeExecutor(options.executor));
    int steps = options.timingFrames * int(shootings.size());
    for (const Shooting& shooting : shootings) steps += int(shooting.shots.size() * choices.size());

    LookupStudy study;
    study.isQuick = options.isQuick;
    for (const Study& known : studies())
        if (known.name == "lookups") study.question = known.question;
    LookupTimes times(choices, sizes.lixels, options.timingFrames);
    const Stopwatch total;
    {
        Progress progress("study lookups", steps);
        for (const Shooting& shooting : shootings) {
            bool isTimed = options.timingFrames == 0; // by the first picture that all lights have maps in
            for (const Shot& shot : shooting.shots) {
                const StudiedPicture picture(shooting, shot, *executors.front());
                for (ResultRow& row : rowsOfShot(picture, shot, sizes, executors, progress))
                    study.run.rows.push_back(std::move(row));
                isTimed = isTimed || times.add(picture, shot, progress);
            }
        }
    }
    finishResults(study.run, options.commandLine, total.seconds(), executors.front()->host());
    addUp(choices, study);
    for (std::size_t i = 0; i < study.lookups.size(); ++i) study.lookups[i].times = times.of(i);
    study.fronts = frontsAgainst(kBytes, study.lookups);
    if (options.timingFrames > 0) study.frontsOfTimes = frontsAgainst(kTime, study.lookups);
    return finishStudyOfRows(study, options, print);
}

} // namespace lixel::app
