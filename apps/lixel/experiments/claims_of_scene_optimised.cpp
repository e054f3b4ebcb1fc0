// SPDX-License-Identifier: MIT
#include "experiments/claim_rules.h"
#include "experiments/claims_of_papers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

// H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007. Its normal maps of section 3's times are focused.
namespace lixel::app {
namespace {

constexpr const char *kNormal = "normal-against-focused", *kTable1 = "scene-optimised-table1",
                     *kTable2 = "scene-optimised-table2", *kTable3 = "scene-optimised-table3";
constexpr const char* kPlanningWeighsMore = "planning weighs more against so few pixels and objects";

constexpr Rule kRules[] = {
    {.experiment = kNormal,
     .sentence = "The normal map has 2.25 times the errors of Focused.",
     .source = "Table 1",
     .keys = "normal over focused, all lights",
     .least = 2.245,
     .reading = "ratio of errors; at least the paper's 2.245"},

    {.experiment = kTable1,
     .sentence = "Focused has 27.65 % more errors than Optimal.",
     .source = "Table 1",
     .keys = "using all data: {Focused}",
     .over = "using all data: Optimal",
     .least = 1.2765,
     .reading = "errors over those of Optimal; at least the paper's 1.277"},
    {.experiment = kTable1,
     .sentence = "LiSPSM has 55.33 % more errors than Optimal.",
     .source = "Table 1",
     .keys = "using all data: {LiSPSM}",
     .over = "using all data: Optimal",
     .least = 1.5533,
     .reading = "errors over those of Optimal; at least the paper's 1.553"},
    {.experiment = kTable1,
     .sentence = "Plane has 315.09 % more errors than Optimal.",
     .source = "Table 1",
     .keys = "using all data: {Plane}",
     .over = "using all data: Optimal",
     .least = 4.1509,
     .reading = "errors over those of Optimal; at least the paper's 4.151",
     .quick = Quick::LeavesOpen,
     .whyOpen = "few lights have most of its errors"},
    {.experiment = kTable1,
     .sentence = "Normal has 186.60 % more errors than Optimal.",
     .source = "Table 1",
     .keys = "using all data: {Normal}",
     .over = "using all data: Optimal",
     .least = 2.866,
     .reading = "errors over those of Optimal; at least the paper's 2.866"},
    {.experiment = kTable1,
     .sentence = "LiSPSM makes more errors than Focused.",
     .source = "Table 1",
     .keys = "using all data: {LiSPSM}",
     .over = "using all data: Focused",
     .least = 1,
     .reading = "errors over those of Focused; at least 1"},
    {.experiment = kTable1,
     .sentence = "Heuristic fits perhaps do no worse than the normal map.",
     .source = "section 1",
     .keys = "using all data: {*SM}",
     .over = "using all data: Normal",
     .most = 1,
     .reading = "errors over those of Normal; at most 1"},
    {.experiment = kTable1,
     .sentence = "LiSPSM is one of the well behaved representatives of its family.",
     .source = "section 3",
     .keys = "using all data: {?SM}",
     .over = "using all data: LiSPSM",
     .least = 1,
     .reading = "errors over those of LiSPSM; at least 1",
     .quick = Quick::Decides},
    {.experiment = kTable1,
     .sentence = "Accounting for skew provides minimal benefit.",
     .source = "section 2.3",
     .keys = "using all data: Best, sheared",
     .over = "using all data: Best",
     .least = 0.95,
     .most = 1.05,
     .reading = "errors with a shear over those without; 0.95 to 1.05",
     .quick = Quick::Decides},
    {.experiment = kTable1,
     .sentence = "One map cannot both sample a plane perfectly and hold the whole frustum in some configurations.",
     .source = "section 1",
     .keys = "using all data: Plane",
     .over = "using all data: Plane else focused",
     .least = 1.05,
     .reading = "errors of the plane's map alone over those with a second one; at least 1.05"},

    {.experiment = kTable2,
     .sentence = "With one light optimised maps cost at most 1.19 of a focused frame.",
     .source = "Table 2",
     .keys = "1 light, {*}: optimal over focused, mean",
     .most = 1.19,
     .reading = "ratio of frame times; at most 1.19",
     .quick = Quick::CanOnlyBearOut,
     .whyOpen = kPlanningWeighsMore},
    {.experiment = kTable2,
     .sentence = "With four lights they cost at most 1.11 of it.",
     .source = "Table 2",
     .keys = "4 lights, {*}: optimal over focused, mean",
     .most = 1.11,
     .reading = "ratio of frame times; at most 1.11",
     .quick = Quick::CanOnlyBearOut,
     .whyOpen = kPlanningWeighsMore},
    {.experiment = kTable2,
     .sentence = "The discrepancy in frame rates shrinks as lights are added.",
     .source = "section 3",
     .keys = "4 lights, {*}: optimal over focused, mean",
     .over = "1 light, {*}: optimal over focused, mean",
     .most = 1,
     .reading = "ratio of frame times with four lights over that with one; at most 1",
     .quick = Quick::Decides},
    {.experiment = kTable2,
     .sentence = "For four lights, optimised maps of 1250 a side give similar quality to normal ones of 1750.",
     .source = "section 3",
     .keys = "4 lights: {optimal * over focused *}, misclassified",
     .most = 1.05,
     .reading = "ratio of errors; at most 1.05",
     .quick = Quick::LeavesOpen,
     .whyOpen = "of so small pictures only some dozens of samples are wrong"},
    {.experiment = kTable2,
     .sentence = "That costs about 7 % of the frame rate.",
     .source = "section 3",
     .keys = "4 lights: {optimal * over focused *}, frame rate",
     .least = 0.93,
     .reading = "ratio of frame rates; at least 0.93",
     .quick = Quick::CanOnlyBearOut,
     .whyOpen = kPlanningWeighsMore},
    {.experiment = kTable2,
     .sentence = "Up to 31 additional lights add no extra cost to the readback.",
     .source = "section 2.4",
     .keys = "readback, 32 lights over 1",
     .most = 1.1,
     .reading = "ratio of times; at most 1.1",
     .quick = Quick::Decides},
    {.experiment = kTable2,
     .sentence = "The costs of observing are amortised over the lights.",
     .source = "section 2.4",
     .keys = "sample pass and readback, 32 lights over 1",
     .most = 16,
     .reading = "ratio of times, 32 if nothing were shared; at most 16",
     .quick = Quick::Decides},

    {.experiment = kTable3,
     .sentence = "The optimiser that runs at each frame is inexpensive.",
     .source = "section 1, Table 3",
     .keys = "optimal: optimisation, share",
     .most = 12.43,
     .reading = "percent of the frame; at most the paper's 12.43",
     .quick = Quick::CanOnlyBearOut,
     .whyOpen = kPlanningWeighsMore},
    {.experiment = kTable3,
     .sentence = "The convex hull takes 1.96 % of a frame with optimised maps.",
     .source = "Table 3",
     .keys = "optimal: convex hull, which is part of it, share",
     .most = 1.96,
     .reading = "percent of the frame; at most that",
     .quick = Quick::CanOnlyBearOut,
     .whyOpen = kPlanningWeighsMore},
    {.experiment = kTable3,
     .sentence = "Planning normal maps takes 0.40 % of a frame.",
     .source = "Table 3",
     .keys = "normal: optimisation, share",
     .most = 0.4,
     .reading = "percent of the frame; at most that",
     .quick = Quick::CanOnlyBearOut,
     .whyOpen = kPlanningWeighsMore},
    {.experiment = kTable3,
     .sentence = "With four lights a frame with optimised maps takes 1.35 of one with normal maps.",
     .source = "Table 3",
     .keys = "optimal over normal, mean",
     .most = 1.353,
     .reading = "ratio of frame times; at most the paper's 1.353",
     .quick = Quick::CanOnlyBearOut,
     .whyOpen = kPlanningWeighsMore},
};

constexpr std::array kFive{"Optimal", "Focused", "LiSPSM", "Plane", "Normal"};

double errorsOf(std::string_view row, std::string_view method, const Reproduction& of)
{
    return numberAt(fmt::format("{}: {}", row, method), of).value_or(std::nan(""));
}

void addFewest(const Reproduction& of, std::vector<ReproducedClaim>& to)
{
    Settled claim{.sentence = "Over all lights the optimised map has the fewest errors of the five.",
                  .source = "section 1, Table 1",
                  .measured = "",
                  .reading = "misclassified pixels a picture",
                  .holds = true};
    for (const char* method : kFive) {
        const double errors = errorsOf("using all data", method, of);
        claim.holds = claim.holds && errors >= errorsOf("using all data", kFive.front(), of);
        tell(claim.measured, method, errors);
    }
    to.push_back(claimOf(claim, of));
}

// In the worst tenth by each method, and by its own: what robustness and its lack are taken for.
void addWorst(const Reproduction& of, std::vector<ReproducedClaim>& to)
{
    constexpr const char* kFewLights = "a tenth of so few lights is a handful";
    Settled robust{.sentence = "Optimising is robust to any configuration of light and camera.",
                   .source = "section 1, Table 1",
                   .measured = "",
                   .reading = "least errors of the other four over Optimal's, in the worst tenth by each; at least 1",
                   .holds = true,
                   .quick = Quick::LeavesOpen,
                   .whyOpen = kFewLights};
    Settled poor{.sentence = "Other methods can perform very poorly for some lights.",
                 .source = "abstract, section 1",
                 .measured = "",
                 .reading = "errors over Optimal's in the worst tenth by each; somewhere at least 2",
                 .quick = Quick::CanOnlyBearOut,
                 .whyOpen = kFewLights};
    for (const char* by : kFive) {
        const std::string row = fmt::format("worst 10 % by {}", by);
        const double optimal = errorsOf(row, "Optimal", of), own = errorsOf(row, by, of) / optimal;
        double least = kAny;
        for (std::size_t i = 1; i < kFive.size(); ++i) least = std::min(least, errorsOf(row, kFive[i], of) / optimal);
        robust.holds = robust.holds && least >= 1;
        tell(robust.measured, by, least);
        if (std::string_view(by) != "LiSPSM" && std::string_view(by) != "Plane") continue; // the methods of others
        poor.holds = poor.holds || own >= 2;
        tell(poor.measured, by, own);
    }
    to.push_back(claimOf(robust, of));
    to.push_back(claimOf(poor, of));
}

// "The cost of read-back makes any benefit moot" with one light: a larger normal map for less.
void addMootForOneLight(const Reproduction& of, std::vector<ReproducedClaim>& to)
{
    const std::vector<Place> ratios = placesOf("1 light, {*}: optimal over focused, mean", of),
                             rates = placesOf("1 light, {*}: focused", of);
    if (ratios.size() != rates.size() || ratios.empty()) return;
    Settled claim{.sentence = "With a single light and texture memory to spare the readback makes any benefit moot.",
                  .source = "section 4",
                  .measured = ratios.size() > 1 ? "" : "one size of maps",
                  .reading = "frame time of the next larger normal maps over that of optimised ones; at most 1",
                  .holds = ratios.size() > 1,
                  .isOfTiming = true,
                  .quick = ratios.size() > 1 ? Quick::Decides : Quick::LeavesOpen,
                  .whyOpen = "it needs two"};
    for (std::size_t i = 0; i + 1 < ratios.size(); ++i) {
        const double optimised = ratios[i].value / rates[i].value, larger = 1 / rates[i + 1].value;
        claim.holds = claim.holds && larger <= optimised;
        tell(claim.measured, fmt::format("{} for {}", rates[i + 1].name, ratios[i].name), larger / optimised);
    }
    to.push_back(claimOf(claim, of));
}

} // namespace

void addClaimsOfSceneOptimised(std::string_view experiment, const Reproduction& of, std::vector<ReproducedClaim>& to)
{
    if (experiment == kTable1 && !of.tables.empty()) addFewest(of, to), addWorst(of, to);
    if (experiment == kTable2) addMootForOneLight(of, to);
    settleAll(kRules, experiment, of, to);
}

} // namespace lixel::app
