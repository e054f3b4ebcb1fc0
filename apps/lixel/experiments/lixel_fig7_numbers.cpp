// SPDX-License-Identifier: MIT
#include "experiments/lixel_fig7_numbers.h"

#include "lixel/base/median.h"

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
constexpr double kComparable = 2;    // times the error: what "comparably" is taken for
constexpr double kSignificant = 1.5; // and "significantly worse"

// A number of the frames that a technique served, by frame: mostly misclassified percent.
using ByFrame = std::map<std::string, double>;

double percentOf(const SampleCount& count)
{
    return count.samples > 0 ? 100 * double(count.misclassified) / double(count.samples) : 0;
}

enum class Where { Everywhere, OnPlanes, OffPlanes, OnWall };

SampleCount countOf(const Measurement& m, Where where)
{
    if (where == Where::Everywhere) return {m.lightFacing, m.misclassified};
    SampleCount sum;
    for (const PlaneSamples& of : m.planes)
        if (where == Where::OnWall ? of.plane == "wall" : of.plane.empty() == (where == Where::OffPlanes))
            sum.samples += of.count.samples, sum.misclassified += of.count.misclassified;
    return sum;
}

// Samples on planes with a lixel a pixel that are wrong though no caster's edge is within a 64th of a lixel.
double wrongBesideEdges(const Measurement& m)
{
    double wrong = 0;
    for (const PlaneSamples& of : m.planes)
        if (!of.plane.empty()) wrong += double(of.count.misclassified - (of.causes ? of.causes->nearEdge : 0));
    return wrong;
}

// Lixels of the maps that are for planes, all or the largest.
double lixelsOfPlanes(const Measurement& m, bool isLargest)
{
    double sum = 0, most = 0;
    for (const RegionUse& region : m.regions) {
        if (region.plane.empty()) continue;
        const double lixels = double(region.width) * region.height;
        sum += lixels, most = std::max(most, lixels);
    }
    return isLargest ? most : sum;
}

double pixelsOf(const ResultRow& row)
{
    const std::size_t x = row.size.find('x');
    return std::stod(row.size.substr(0, x)) * std::stod(row.size.substr(x + 1));
}

class SceneRows
{
public:
    SceneRows(const std::string& scene, std::span<const ResultRow> rows, bool isOfLowCamera)
    {
        for (const ResultRow& row : rows)
            if (row.scene == scene && row.view.ends_with(kLowCamera) == isOfLowCamera) rows_.push_back(&row);
    }

    // All frames, or those of a sweep, or all but those.
    enum class Which { All, Of, Except };
    ByFrame of(std::string_view technique, Which which = Which::All, std::string_view sweep = "",
               Where where = Where::Everywhere) const
    {
        return by(technique, [&](const ResultRow& row) -> std::optional<double> {
            if (which != Which::All && (row.light == sweep) != (which == Which::Of)) return std::nullopt;
            return percentOf(countOf(*row.measured(), where));
        });
    }
    ByFrame of(std::string_view technique, Where where) const { return of(technique, Which::All, "", where); }

    // What something says of each row of a technique.
    template <typename Of>
    ByFrame by(std::string_view technique, const Of& of) const
    {
        ByFrame out;
        for (const ResultRow* row : rows_)
            if (row->technique == technique && row->measured())
                if (const std::optional<double> value = of(*row)) out[row->view] = *value;
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
        mean(rows.of(kConventional, Of, kElongated, Where::OnPlanes)) /
            mean(rows.of(kPlanes, Of, kElongated, Where::OnPlanes)),
        kNoNumbers);
    add("other shadows, focused over planes", "ratio of means",
        mean(rows.of(kConventional, Except, kElongated)) / mean(rows.of(kPlanes, Except, kElongated)), kNoNumbers);
    add("psm errs less than focused", "percent of frames", framesWorse(conventional, perspective, 1),
        "section 4: PSM \"occasionally did better\"");
    add("light in front, psm over focused", "ratio of means",
        mean(rows.of(kPerspective, Of, kInFront)) / mean(rows.of(kConventional, Of, kInFront)),
        "section 4: light in front, PSM \"often deteriorated badly\"");
    add("light elsewhere, psm over focused", "ratio of means",
        mean(rows.of(kPerspective, Except, kInFront)) / mean(rows.of(kConventional, Except, kInFront)), kNoNumbers);
    add("psm errs 1.5 times as much as focused", "percent of frames",
        framesWorse(perspective, conventional, kSignificant), "section 1: PSM \"often performs significantly worse\"");
    add("planes err more than focused", "percent of frames", framesWorse(planes, conventional, 1),
        "section 4: \"some cases where we did perform worse\"");
    add("planes without one of their three maps", "frames", rows.withoutAllMaps(kPlanes, 3),
        "section 3: three maps always");
}

// Of floor and wall against everything else.
void addOffPlanes(const std::string& scene, const SceneRows& rows, std::vector<ReproducedNumber>& numbers)
{
    const ByFrame planes = rows.of(kPlanes, Where::OffPlanes);
    for (const char* other : {kConventional, kPerspective})
        numbers.push_back({fmt::format("{}, against {}: off floor and wall planes err no more", scene, other),
                           "percent of frames", 100 - framesWorse(planes, rows.of(other, Where::OffPlanes), 1),
                           std::nullopt, "section 1: \"typically not worse\" on other geometry"});
    numbers.push_back({fmt::format("{}: planes, errors off floor and wall over those on them", scene), "ratio of means",
                       mean(planes) / mean(rows.of(kPlanes, Where::OnPlanes)), std::nullopt,
                       "section 1: still \"significantly aliased\""});
}

// Of frames that are shown: with a lixel a pixel on planes, and without a map for what is on none.
void addLixelAPixel(const std::string& scene, const SceneRows& rows, std::vector<ReproducedNumber>& numbers)
{
    const auto add = [&](std::string_view what, const char* unit, double ours, const char* source) {
        if (std::isfinite(ours))
            numbers.push_back({fmt::format("{}: {}", scene, what), unit, ours, std::nullopt, source});
    };
    add("floor and wall with a lixel a pixel", "percent of light-facing samples there",
        mean(rows.of(kPlanesExactly, Where::OnPlanes)), "abstract: \"perfectly sampled\"");
    add("floor and wall with a lixel a pixel, not at a caster's edge", "percent of light-facing samples there",
        mean(rows.by(kPlanesExactly,
                     [](const ResultRow& row) {
                         const double samples = double(countOf(*row.measured(), Where::OnPlanes).samples);
                         return samples > 0 ? std::optional(100 * wrongBesideEdges(*row.measured()) / samples)
                                            : std::nullopt;
                     })),
        "abstract: \"perfectly sampled\"");
    add("lixels of floor's and wall's maps over samples there", "ratio, a lixel a pixel",
        mean(rows.by(kPlanesExactly,
                     [](const ResultRow& row) {
                         const double samples = double(countOf(*row.measured(), Where::OnPlanes).samples);
                         return samples > 0 ? std::optional(lixelsOfPlanes(*row.measured(), false) / samples)
                                            : std::nullopt;
                     })),
        "section 1: \"wasted\" lixels");
    const ByFrame largest = rows.by(kPlanesExactly, [](const ResultRow& row) {
        return std::optional(lixelsOfPlanes(*row.measured(), true) / pixelsOf(row));
    });
    if (!largest.empty())
        add("largest map of floor or wall over the picture", "ratio, a lixel a pixel", worst(largest),
            "section 2: \"fewer lixels than pixels\"");
    const auto outside = [](const ResultRow& row) {
        return std::optional(100 * double(row.measured()->unserved) / pixelsOf(row));
    };
    add("samples that no map of a plane holds", "percent of the picture", mean(rows.by(kPlanesAlone, outside)),
        "section 3: fallback \"rarely hit\"");
}

void addLowCamera(const std::string& scene, const SceneRows& rows, std::vector<ReproducedNumber>& numbers)
{
    const auto add = [&](std::string_view what, const char* unit, double ours, const char* source) {
        if (std::isfinite(ours))
            numbers.push_back({fmt::format("{}: camera low, {}", scene, what), unit, ours, std::nullopt, source});
    };
    add("shadows on the wall, planes(floor) over focused", "ratio",
        mean(rows.of(kFloor, Where::OnWall)) / mean(rows.of(kConventional, Where::OnWall)),
        "section 4: one case where planes are worse");
    add("samples outside the floor's map", "percent of the picture",
        mean(rows.by(kFloorAlone,
                     [](const ResultRow& row) {
                         return std::optional(100 * double(row.measured()->unserved) / pixelsOf(row));
                     })),
        "section 1: one plane \"may require two shadow maps\"");
}

} // namespace

std::vector<ReproducedNumber> numbersOfScene(const std::string& scene, std::span<const ResultRow> rows)
{
    const SceneRows ofScene(scene, rows, false);
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
    addOffPlanes(scene, ofScene, numbers);
    addLixelAPixel(scene, ofScene, numbers);
    addLowCamera(scene, SceneRows(scene, rows, true), numbers);
    return numbers;
}

std::vector<ReproducedNumber> timingNumbersOf(const std::string& scene, std::span<const ResultRow> rows)
{
    const SceneRows ofScene(scene, rows, false);
    const auto medianMs = [&](const char* technique) {
        std::vector<double> ms;
        for (const auto& [frame, one] :
             ofScene.by(technique, [](const ResultRow& row) { return row.measured()->timing.frameMs; }))
            ms.push_back(one);
        return ms.empty() ? std::nan("") : median(ms);
    };
    const double planes = medianMs(kPlanes), conventional = medianMs(kConventional);
    std::vector<ReproducedNumber> numbers;
    if (planes > 0)
        numbers.push_back({fmt::format("{}: {}", scene, kPlanes), "frames a second", 1000 / planes,
                           kPaperFramesPerSecond, "section 4, its machine, maps of 1024x1024"});
    if (planes > 0 && conventional > 0)
        numbers.push_back({fmt::format("{}: planes over focused, frame", scene), "ratio of times",
                           planes / conventional, std::nullopt, "sections 1 and 4: two more passes over the geometry"});
    return numbers;
}

} // namespace lixel::app
