// SPDX-License-Identifier: MIT
#include "lixel/report/warps.h"

#include "evenness.h"
#include "finish_study.h"
#include "one_light.h"
#include "progress.h"
#include "study.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

// The views and lights of a scene: errors of texture warps, and how evenly they spread samples, as their parameters change one by one.
namespace lixel::app {
namespace {

constexpr const char* kBase = "focused"; // under all curves

// One parameter of a warp; the values that it has by itself are added.
struct Curve
{
    const char* warp;
    const char* parameter;
    std::vector<const char*> values;
};

std::vector<Curve> curves()
{
    const std::vector<const char*> smooth{"0", "1/128", "1/64", "1/32", "1/16", "1/8", "1/4", "1"},
        power{"0.4", "0.5", "2/3", "0.8", "1"}, floor{"0", "0.02", "0.05", "0.1", "0.2"},
        importance{"count",       "count*distance",   "count*normal",
                   "count*edges", "count*boundaries", "count*max(edges,boundaries)",
                   "distance",    "distance*normal"};
    return {{"now", "smooth", smooth},
            {"now", "power", power},
            {"now", "floor", floor},
            {"now", "importance", importance},
            {"now", "lines", {"nearest", "interpolated"}},
            {"now", "grid", {"32", "64", "128", "256", "512"}},
            {"now", "analysis", {"backward", "hybrid"}},
            {"rtw", "smooth", smooth},
            {"rtw", "power", power},
            {"rtw", "floor", floor},
            {"rtw", "importance", importance}};
}

// Whole techniques, and the two warps where they are compared for evenness: equal counts, and windows of 7 lines of 512.
std::vector<const char*> others()
{
    return {"uniform",
            "minimal-frustum",
            "desired-view",
            "paper:rtw",
            "paper:now",
            "desired-view+rtw",
            "desired-view+now",
            "lispsm+now",
            "scene-optimal",
            "scene-optimal+now",
            "focused+rtw(importance=count,power=1,smooth=3/512,floor=0)",
            "focused+now(importance=count,power=1,smooth=3/512,floor=0)"};
}

struct Variant
{
    WarpStudy::Row row;
    TechniqueChoice choice;
    double logRatios = 0;
    int ratios = 0;
};

Variant variant(const char* curve, const char* value, const std::string& technique)
{
    Variant v;
    v.row.curve = curve;
    v.row.value = value;
    v.row.technique = technique;
    v.choice = readTechniques(technique).front();
    return v;
}

std::vector<Variant> variants()
{
    std::vector<Variant> out;
    for (const Curve& curve : curves()) {
        const Technique own = readTechniques(fmt::format("{}+{}", kBase, curve.warp)).front().technique;
        for (const char* value : curve.values) {
            const std::string name = fmt::format("{} {}", curve.warp, curve.parameter);
            out.push_back(
                variant(name.c_str(), value, fmt::format("{}+{}({}={})", kBase, curve.warp, curve.parameter, value)));
            out.back().row.isOwn = out.back().choice.technique == own;
        }
    }
    for (const char* technique : others()) out.push_back(variant("technique", technique, technique));
    return out;
}

class WarpCurves
{
public:
    explicit WarpCurves(LixelSize lixels) : lixels_(lixels), variants_(variants()) {}

    std::size_t size() const { return variants_.size(); }

    // All variants under one light; those that are the same are measured once.
    void add(const StudiedPicture& picture, const Light& light, Progress& progress)
    {
        const OneLight one(picture, light);
        const auto focused = one.score(readTechniques(kBase).front(), lixels_, {});
        std::vector<std::pair<const Variant*, std::optional<Measured>>> measured;
        for (Variant& v : variants_) {
            progress.step(fmt::format("{}: {}", light.name, v.row.technique));
            const auto known = std::ranges::find_if(
                measured, [&](const auto& m) { return m.first->choice.technique == v.choice.technique; });
            const auto m = known != measured.end() ? known->second : measure(picture, one, v.choice);
            measured.emplace_back(&v, m);
            if (focused && m) addTo(v, *m, *focused);
        }
    }

    std::vector<WarpStudy::Row> rows() const
    {
        std::vector<WarpStudy::Row> out;
        for (const Variant& v : variants_) {
            WarpStudy::Row row = v.row;
            const double n = std::max(row.lights, 1);
            row.percent /= n, row.usedShare /= n, row.countVariation /= n;
            row.ratioToFocused = v.ratios > 0 ? std::exp(v.logRatios / v.ratios) : 1;
            out.push_back(row);
        }
        return out;
    }

private:
    struct Measured
    {
        Score score;
        Evenness evenness;
        std::int64_t knotBytes = 0;
    };

    std::optional<Measured> measure(const StudiedPicture& picture, const OneLight& one,
                                    const TechniqueChoice& choice) const
    {
        const FramePlan plan = one.plan(choice, lixels_, {});
        if (plan.lights.front().refused) return std::nullopt;
        return Measured{one.score(plan), evennessOf(plan.lights.front(), picture.samples, one.light()),
                        std::int64_t(plan.warpTable.size() * sizeof(float))};
    }

    static void addTo(Variant& v, const Measured& m, const Score& focused)
    {
        ++v.row.lights;
        v.row.misclassified += m.score.misclassified;
        v.row.percent += m.score.misclassifiedPercent();
        v.row.usedShare += m.evenness.usedShare;
        v.row.countVariation += m.evenness.countVariation;
        v.row.knotBytes = std::max(v.row.knotBytes, m.knotBytes);
        if (focused.misclassified == 0) return;
        v.logRatios +=
            std::log(double(std::max<std::int64_t>(m.score.misclassified, 1)) / double(focused.misclassified));
        ++v.ratios;
    }

    LixelSize lixels_;
    std::vector<Variant> variants_;
};

// A table a curve.
void print(const WarpStudy& study, std::FILE* to)
{
    fmt::print(
        to,
        "{}, pictures {}, {} lixels: misclassified samples, their mean percent, against focused, share of lixels "
        "that serve\na sample, variation of their number; *: the warp's own value\n",
        study.scene, study.size, study.lixels);
    std::string curve;
    for (const WarpStudy::Row& row : study.rows) {
        if (row.curve != curve) fmt::print(to, "\n{}\n", row.curve);
        curve = row.curve;
        fmt::print(to, "  {:<60}{} {:>9} {:>8.4f} % {:>7.3f} {:>7.3f} {:>7.2f}\n", row.value, row.isOwn ? "*" : " ",
                   row.misclassified, row.percent, row.ratioToFocused, row.usedShare, row.countVariation);
    }
}

} // namespace

int studyWarps(const StudyOptions& options)
{
    WarpStudy study;
    const LixelSize lixels = readSize(options.lixels, "--lixels", kMostLixelsASide);
    const Shooting shooting = prepare(options.picture, true);
    const std::unique_ptr<Executor> executor = makeExecutor(options.executor);
    study.scene = shooting.sceneName;
    study.size = fmt::format("{}x{}", shooting.width, shooting.height);
    study.lixels = toString(lixels);
    study.executor = executor->name();
    WarpCurves curves(lixels);
    int lights = 0;
    for (const Shot& shot : shooting.shots) lights += int(shot.lights.size());
    const Stopwatch total;
    {
        Progress progress("study warps", lights * int(curves.size()));
        for (const Shot& shot : shooting.shots) {
            const StudiedPicture picture(shooting, shot, *executor);
            for (const Light& light : shot.lights) curves.add(picture, light, progress);
        }
    }
    study.rows = curves.rows();
    tellWarnings(*shooting.scene);
    return finishStudy(study, options, total.seconds(), executor->host(), print);
}

} // namespace lixel::app
