// SPDX-License-Identifier: MIT
#include "experiments/claims.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include <fmt/format.h>

namespace lixel::app {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

// What a claim is settled by: numbers whose keys begin and end so. It holds where all of them, or the best or the worst alone, lie
// between two bounds. Papers rarely give bounds; these are our reading of their words, and are said beside what was measured.
enum class Judged { All, Least, Most };
struct Rule
{
    const char *experiment, *sentence, *source;
    const char *begins, *ends;
    Judged judged;
    double least, most;
    const char* reading;
};

constexpr Rule kRules[] = {
    {"lixel-fig7", "For many views conventional, perspective and plane-optimal maps perform comparably.", "section 4",
     "", "focused, psm, planes within twice each other", Judged::All, 50, kAny,
     "percent of frames with the three within twice each other; at least 50"},
    {"lixel-fig7", "With elongated shadows the conventional map becomes quite pixelated.", "section 4", "",
     "elongated shadows, focused over planes", Judged::All, 1.05, kAny,
     "errors of focused over those of planes; at least 1.05"},
    {"lixel-fig7", "The perspective map occasionally does better than the conventional one.", "section 4", "",
     "psm errs less than focused", Judged::All, 1, 50, "percent of frames; 1 to 50"},
    {"lixel-fig7", "With the light in front of the camera perspective maps often deteriorate badly.", "section 4", "",
     "light in front, psm over focused", Judged::All, 1.5, kAny, "errors of psm over those of focused; at least 1.5"},
    {"lixel-fig7", "There are cases where plane-optimal maps perform worse than conventional ones.", "section 4", "",
     "planes err more than focused", Judged::Most, 1, kAny, "percent of frames; more than none"},
    {"lixel-fig7", "Floor, wall and the rest are served by three maps.", "section 3", "",
     "planes without one of their three maps", Judged::All, 0, 0, "frames without one of them; none"},

    {"scene-optimised-table1", "Focused has 27.65 % more errors than Optimal.", "Table 1", "Optimal, fewer",
     "than Focused", Judged::All, 100 * (1 - 1 / 1.2765), kAny,
     "percent fewer than Focused; at least the paper's 21.7"},
    {"scene-optimised-table1", "LiSPSM makes more errors than Focused.", "Table 1", "LiSPSM, fewer", "than Focused",
     Judged::All, -kAny, 0, "percent fewer than Focused; none"},
    {"scene-optimised-table1", "The normal map has more than twice the errors of Focused.", "Table 1", "Normal, fewer",
     "than Focused", Judged::All, -kAny, -100, "percent fewer than Focused; at most -100"},
    {"scene-optimised-table2", "With one light optimised maps cost at most 1.19 of a focused frame.", "Table 2",
     "1 light,", ": optimal over focused, mean", Judged::All, 0, 1.19, "ratio of frame times; at most 1.19"},
    {"scene-optimised-table2", "With four lights they cost at most 1.11 of it.", "Table 2", "4 lights,",
     ": optimal over focused, mean", Judged::All, 0, 1.11, "ratio of frame times; at most 1.11"},
    {"scene-optimised-table2",
     "For four lights, optimised maps of 1250 a side give similar quality to normal ones of 1750.", "section 3",
     "4 lights: optimal", ", misclassified", Judged::Least, 0, 1.05, "ratio of errors; at most 1.05"},
    {"scene-optimised-table2", "That costs about 7 % of the frame rate.", "section 3", "4 lights: optimal",
     ", frame rate", Judged::All, 0.93, kAny, "ratio of frame rates; at least 0.93"},
    {"scene-optimised-table2", "Up to 31 additional lights add no extra cost to the readback.", "section 2.4",
     "readback, 32 lights over 1", "", Judged::All, 0, 1.1, "ratio of times; at most 1.1"},

    {"multiple-depth-figures", "On planar receivers three depths and 3x3 taps are comparable to one depth and 4x4.",
     "Figure 6", "planar, depths(3", "pcf(9): RMSE over that of PCF(16,1), against the 4x4 footprint of PCF(16,1)",
     Judged::Least, 0, 1.1, "RMSE over that of PCF(16,1), the best rule to choose depths; at most 1.1"},
    {"multiple-depth-figures", "On curved receivers the results are very similar.", "Figure 7", "curved, depths(3",
     "pcf(9): RMSE over that of PCF(16,1), against the 4x4 footprint of PCF(16,1)", Judged::Least, 0, 1.1,
     "RMSE over that of PCF(16,1), the best rule to choose depths; at most 1.1"},
    {"multiple-depth-cost", "Two depths and nine taps cost less than sixteen taps once f > 1.28 times the lixels.",
     "section 6, equation 5", "measured break-even, f", "", Judged::All, 0, 1.28,
     "measured break-even in fragments a lixel; at most 1.28"},
    {"multiple-depth-cost", "A screen of 656x656 suffices for a map of 512x512.", "section 6, equation 6",
     "equation 6: side", "", Judged::All, 580, 657,
     "side by the paper's own equation; 656 if 1.28 is meant of sides, else 579"},

    {"now-table3", "Shadow volumes are the bound that no shadow map may be slower than.", "section 4", "",
     ": Ours over SV, shadows alone", Judged::All, 0, 1, "ratio of times; at most 1"},
    {"now-table3", "The method is slightly slower than RTW.", "section 4, Table 3", "",
     ": Ours over RTW, shadows alone", Judged::All, 1, 1.25, "ratio of times; 1 to 1.25"},
};

// One number over another whose key begins alike, in each scene; it holds where all ratios are at most `most`.
struct PairRule
{
    const char *experiment, *sentence, *source;
    const char *of, *over; // ends of the keys
    double most;
};

constexpr PairRule kPairRules[] = {
    {"now-table1", "Non-orthogonal warps give better results than RTW.", "teaser, section 5", ": Ours, misclassified",
     ": RTW, misclassified", 1},
    {"now-table3", "Non-orthogonal warps give better results than RTW.", "section 4, Figure 7", ": Ours, misclassified",
     ": RTW, misclassified", 1},
    {"now-table3", "Warps perform better than the minimal shadow frustum where the camera sees much of a scene.",
     "section 4, Figures 6 and 7", ": Ours, misclassified", ": MIN-SM, misclassified", 1},
    {"now-table3", "Warps perform better than the desired view alone where the camera sees much of a scene.",
     "section 4, Figures 6 and 7", ": Ours, misclassified", ": Ours-DV, misclassified", 1},
    {"now-table3", "The minimal frustum is visually better than the desired view.", "section 4",
     ": MIN-SM, misclassified", ": Ours-DV, misclassified", 1},
    {"now-table3", "The desired view is the major part of the decrease of errors.", "section 4",
     ": Ours-DV, misclassified", ": SM, misclassified", 0.75},
};

struct Found
{
    const ReproducedNumber* number;
    bool isOfTiming;
};

std::vector<Found> numbersOf(const Rule& rule, const Reproduction& reproduction)
{
    std::vector<Found> found;
    const auto take = [&](const std::vector<ReproducedNumber>& numbers, bool isOfTiming) {
        for (const ReproducedNumber& n : numbers)
            if (n.key.starts_with(rule.begins) && n.key.ends_with(rule.ends)) found.push_back({&n, isOfTiming});
    };
    take(reproduction.numbers, false);
    take(reproduction.timingNumbers, true);
    return found;
}

std::string shortly(double value) { return fmt::format("{:.3g}", value); }

// A key without what all keys of the rule share.
std::string placeOf(const std::string& key, std::size_t begins, std::size_t ends)
{
    std::string place = key.substr(begins, key.size() - begins - ends);
    while (!place.empty() && (place.back() == ' ' || place.back() == ':' || place.back() == ',')) place.pop_back();
    while (!place.empty() && (place.front() == ' ' || place.front() == ',')) place.erase(0, 1);
    return place;
}

void add(std::string& list, const std::string& place, double value)
{
    list += fmt::format("{}{}{}{}", list.empty() ? "" : "; ", place, place.empty() ? "" : " ", shortly(value));
}

std::optional<ReproducedClaim> settle(const Rule& rule, const Reproduction& reproduction)
{
    const std::vector<Found> found = numbersOf(rule, reproduction);
    if (found.empty()) return std::nullopt;
    const std::size_t begins = std::string_view(rule.begins).size(), ends = std::string_view(rule.ends).size();
    const auto isWithin = [&](const Found& f) { return f.number->ours >= rule.least && f.number->ours <= rule.most; };
    const auto byValue = [](const Found& a, const Found& b) { return a.number->ours < b.number->ours; };
    ReproducedClaim claim{rule.sentence, rule.source, "", false, false};
    for (const Found& f : found) claim.isOfTiming = claim.isOfTiming || f.isOfTiming;
    if (rule.judged == Judged::All) {
        claim.holds = std::ranges::all_of(found, isWithin);
        for (const Found& f : found) add(claim.measured, placeOf(f.number->key, begins, ends), f.number->ours);
    } else {
        const auto& which = rule.judged == Judged::Least ? *std::ranges::min_element(found, byValue)
                                                         : *std::ranges::max_element(found, byValue);
        claim.holds = isWithin(which);
        add(claim.measured, placeOf(which.number->key, begins, ends), which.number->ours);
    }
    claim.measured += fmt::format(" ({})", rule.reading);
    return claim;
}

std::optional<ReproducedClaim> settle(const PairRule& rule, const Reproduction& reproduction)
{
    ReproducedClaim claim{rule.sentence, rule.source, "", true, false};
    for (const ReproducedNumber& of : reproduction.numbers) {
        if (!of.key.ends_with(rule.of)) continue;
        const std::string place = of.key.substr(0, of.key.size() - std::string_view(rule.of).size());
        for (const ReproducedNumber& over : reproduction.numbers) {
            if (over.key != place + rule.over || !(over.ours > 0)) continue;
            claim.holds = claim.holds && of.ours <= rule.most * over.ours;
            add(claim.measured, place, of.ours / over.ours);
        }
    }
    if (claim.measured.empty()) return std::nullopt;
    claim.measured += fmt::format(" (errors of the one over those of the other; at most {:.3g} everywhere)", rule.most);
    return claim;
}

// The paper's five columns come first.
std::optional<ReproducedClaim> fewestOfFive(const Reproduction& reproduction)
{
    if (reproduction.tables.empty() || reproduction.tables.front().rows.empty()) return std::nullopt;
    const ReproducedTable& table = reproduction.tables.front();
    const std::vector<ReproducedTable::Cell>& cells = table.rows.front().cells;
    ReproducedClaim claim{"Over all lights the optimised map has the fewest errors of the five.", "Table 1", "", true,
                          false};
    for (std::size_t column = 0; column < cells.size() && cells[column].papers; ++column) {
        claim.holds = claim.holds && cells[column].ours >= cells.front().ours;
        add(claim.measured, table.columns[column].title, cells[column].ours);
    }
    claim.measured += " misclassified pixels a picture";
    return claim;
}

// All outcomes of all choices, and never more.
std::optional<ReproducedClaim> allShadesSeen(const Reproduction& reproduction)
{
    int all = 0, seen = 0;
    for (const ReproducedNumber& n : reproduction.numbers)
        if (n.papers && n.key.starts_with("PCF(")) ++all, seen += n.ours == *n.papers;
    if (all == 0) return std::nullopt;
    return ReproducedClaim{"A kernel of k taps over n depths has nk + 1 outcomes.", "section 4.2, Table 1",
                           fmt::format("{} of {} entries are seen whole in pictures, none has more", seen, all),
                           seen == all, false};
}

} // namespace

std::vector<ReproducedClaim> claimsOf(std::string_view experiment, const Reproduction& reproduction)
{
    std::vector<ReproducedClaim> claims;
    const auto take = [&](std::optional<ReproducedClaim> claim) {
        if (claim) claims.push_back(std::move(*claim));
    };
    if (experiment == "scene-optimised-table1") take(fewestOfFive(reproduction));
    if (experiment == "multiple-depth-table1") take(allShadesSeen(reproduction));
    for (const Rule& rule : kRules)
        if (experiment == rule.experiment) take(settle(rule, reproduction));
    for (const PairRule& rule : kPairRules)
        if (experiment == rule.experiment) take(settle(rule, reproduction));
    return claims;
}

} // namespace lixel::app
