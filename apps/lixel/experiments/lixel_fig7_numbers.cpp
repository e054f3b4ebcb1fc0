// SPDX-License-Identifier: MIT
#include "experiments/lixel_fig7_numbers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace lixel::app {
namespace {

// Ours and the paper's machine differ by twenty years; it has no other number than this.
constexpr double kPaperFramesPerSecond = 30;

constexpr const char* kNoNumbers = "section 4: shown, no numbers";
constexpr double kComparable = 2; // times the error: what "comparably" is taken for

// Misclassified percent of the frames that a technique served, by frame.
using ByFrame = std::map<std::string, double>;

double percentOf(const SampleCount& count)
{
    return count.samples > 0 ? 100 * double(count.misclassified) / double(count.samples) : 0;
}

SampleCount onPlanes(const Measurement& m)
{
    SampleCount sum;
    for (const PlaneSamples& of : m.planes)
        if (!of.plane.empty()) sum.samples += of.count.samples, sum.misclassified += of.count.misclassified;
    return sum;
}

SampleCount allOf(const Measurement& m) { return {m.lightFacing, m.misclassified}; }

class SceneRows
{
public:
    SceneRows(const std::string& scene, std::span<const ResultRow> rows)
    {
        for (const ResultRow& row : rows)
            if (row.scene == scene) rows_.push_back(&row);
    }

    // All frames, or those of a sweep, or all but those.
    enum class Which { All, Of, Except };
    ByFrame of(std::string_view technique, Which which = Which::All, std::string_view sweep = "",
               bool isOnPlanes = false) const
    {
        ByFrame out;
        for (const ResultRow* row : rows_) {
            if (row->technique != technique || !row->measured()) continue;
            if (which == Which::All || (row->light == sweep) == (which == Which::Of))
                out[row->view] = percentOf(isOnPlanes ? onPlanes(*row->measured()) : allOf(*row->measured()));
        }
        return out;
    }

    // Frames that a technique has not as many maps for as it has sizes, or none.
    int withoutAllMaps(std::string_view technique, std::size_t maps) const
    {
        return int(std::ranges::count_if(rows_, [&](const ResultRow* row) {
            return row->technique == technique && !(row->measured() && row->measured()->regions.size() == maps);
        }));
    }

private:
    std::vector<const ResultRow*> rows_;
};

double mean(const ByFrame& of)
{
    double sum = 0;
    for (const auto& [frame, percent] : of) sum += percent;
    return of.empty() ? std::nan("") : sum / double(of.size());
}

double worst(const ByFrame& of)
{
    double most = 0;
    for (const auto& [frame, percent] : of) most = std::max(most, percent);
    return most;
}

// Percent of the frames that both served in which `a` errs more than `factor` times as much as `b`.
double framesWorse(const ByFrame& a, const ByFrame& b, double factor)
{
    int both = 0, worse = 0;
    for (const auto& [frame, percent] : a)
        if (const auto other = b.find(frame); other != b.end()) ++both, worse += percent > factor * other->second;
    return both > 0 ? 100.0 * worse / both : 0;
}

// Percent of the frames in which the most wrong of three errs at most kComparable times as much as the least wrong.
double framesAlike(const ByFrame& a, const ByFrame& b, const ByFrame& c)
{
    int all = 0, alike = 0;
    for (const auto& [frame, percent] : a) {
        const auto inB = b.find(frame), inC = c.find(frame);
        if (inB == b.end() || inC == c.end()) continue;
        ++all;
        alike += std::max({percent, inB->second, inC->second}) <=
                 kComparable * std::min({percent, inB->second, inC->second});
    }
    return all > 0 ? 100.0 * alike / all : 0;
}

void addClaims(const std::string& scene, const SceneRows& rows, std::vector<ReproducedNumber>& numbers)
{
    using enum SceneRows::Which;
    const auto add = [&](std::string_view what, const char* unit, double ours, const char* source) {
        numbers.push_back({fmt::format("{}: {}", scene, what), unit, ours, std::nullopt, source});
    };
    const ByFrame conventional = rows.of(kConventional), perspective = rows.of(kPerspective), planes = rows.of(kPlanes);
    add("focused, psm, planes within twice each other", "percent of frames",
        framesAlike(conventional, perspective, planes),
        "section 4: \"for many views, all three performed comparably\"");
    add("elongated shadows, focused over planes", "ratio of means",
        mean(rows.of(kConventional, Of, kElongated)) / mean(rows.of(kPlanes, Of, kElongated)),
        "section 4: elongated, \"conventional ... quite pixelated\"");
    add("the same, on floor and wall only", "ratio of means",
        mean(rows.of(kConventional, Of, kElongated, true)) / mean(rows.of(kPlanes, Of, kElongated, true)), kNoNumbers);
    add("other shadows, focused over planes", "ratio of means",
        mean(rows.of(kConventional, Except, kElongated)) / mean(rows.of(kPlanes, Except, kElongated)), kNoNumbers);
    add("psm errs less than focused", "percent of frames", framesWorse(conventional, perspective, 1),
        "section 4: PSM \"occasionally did better\"");
    add("light in front, psm over focused", "ratio of means",
        mean(rows.of(kPerspective, Of, kInFront)) / mean(rows.of(kConventional, Of, kInFront)),
        "section 4: light in front, PSM \"often deteriorated badly\"");
    add("light elsewhere, psm over focused", "ratio of means",
        mean(rows.of(kPerspective, Except, kInFront)) / mean(rows.of(kConventional, Except, kInFront)), kNoNumbers);
    add("planes err more than focused", "percent of frames", framesWorse(planes, conventional, 1),
        "section 4: \"some cases where we did perform worse\"");
    add("planes without one of their three maps", "frames", rows.withoutAllMaps(kPlanes, 3),
        "section 3: three maps always");
}

} // namespace

std::vector<ReproducedNumber> numbersOfScene(const std::string& scene, std::span<const ResultRow> rows)
{
    const SceneRows ofScene(scene, rows);
    std::vector<ReproducedNumber> numbers;
    const auto add = [&](const char* technique, const char* what, double ours) {
        numbers.push_back({fmt::format("{}: {}, {}", scene, technique, what), "percent of light-facing samples", ours,
                           std::nullopt, kNoNumbers});
    };
    for (const char* technique : kComparedMaps) {
        add(technique, "mean", mean(ofScene.of(technique)));
        add(technique, "worst", worst(ofScene.of(technique)));
    }
    addClaims(scene, ofScene, numbers);
    return numbers;
}

std::vector<ReproducedNumber> timingNumbersOf(std::span<const ResultRow> rows)
{
    std::map<std::string, std::vector<double>> byScene;
    for (const ResultRow& row : rows)
        if (row.technique == kPlanes && row.measured() && row.measured()->timing.frameMs)
            byScene[row.scene].push_back(*row.measured()->timing.frameMs);
    std::vector<ReproducedNumber> numbers;
    for (auto& [scene, ms] : byScene) {
        const auto middle = ms.begin() + std::ptrdiff_t(ms.size() / 2);
        std::nth_element(ms.begin(), middle, ms.end());
        numbers.push_back({fmt::format("{}: {}", scene, kPlanes), "frames a second", 1000 / *middle,
                           kPaperFramesPerSecond, "section 4, its machine, maps of 1024x1024"});
    }
    return numbers;
}

} // namespace lixel::app
