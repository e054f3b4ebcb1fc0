// SPDX-License-Identifier: MIT
#include "experiments/claim_rules.h"
#include "experiments/claims_of_papers.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <fmt/format.h>

// T. Milet, J. Navratil, P. Zemcik. An Improved Non-Orthogonal Texture Warping for Better Shadow Rendering. 2015. Errors in
// now-table1 and now-table3 are those of maps that were drawn, in now-figures those of maps made by rays.
namespace lixel::app {
namespace {

constexpr const char *kTable1 = "now-table1", *kTable3 = "now-table3", *kFigures = "now-figures";

constexpr Rule kRules[] = {
    {.experiment = kTable1,
     .sentence = "Shadow volumes provide sample-precise shadows.",
     .source = "section 4",
     .keys = "{*}: SV, misclassified",
     .most = 0.01,
     .reading = "percent; at most 0.01",
     .quick = Quick::Decides},
    {.experiment = kTable1,
     .sentence = "The method is fast: the steps of warping have no crucial impact on overall performance.",
     .source = "sections 1 and 5",
     .keys = "Ours over SM, frame with its plan",
     .most = 2.95,
     .reading = "ratio of frame times; at most the paper's own 2.95",
     .quick = Quick::CanOnlyBearOut,
     .whyOpen = "warping and cutting triangles up weigh more against so few pixels"},
    {.experiment = kTable1,
     .sentence = "Computing the minimal shadow frustum is not expensive.",
     .source = "section 4",
     .keys = "MIN-SM over SM, frame with its plan",
     .most = 1.07,
     .reading = "ratio of frame times; at most the paper's own 1.07"},

    {.experiment = kTable3,
     .sentence = "Shadow volumes are the bound that no shadow map may be slower than.",
     .source = "section 4",
     .keys = "{*}: Ours over SV, shadows alone",
     .most = 1,
     .reading = "ratio of times; at most 1",
     .quick = Quick::CanOnlyBearOut,
     .whyOpen = "volumes fill far fewer pixels"},
    {.experiment = kTable3,
     .sentence = "The method is slightly slower than RTW.",
     .source = "section 4, Table 3",
     .keys = "{*}: Ours over RTW, shadows alone",
     .least = 1,
     .most = 1.43,
     .reading = "ratio of times; 1 to 1.43, which Table 1 of the paper has"},
    {.experiment = kTable3,
     .sentence = "Non-orthogonal warps give better results than RTW.",
     .source = "teaser, Figure 7, sections 4 and 5",
     .keys = "{*}: Ours, misclassified",
     .over = "{*}: RTW, misclassified",
     .most = 1,
     .reading = "ratio of errors, maps drawn as the paper draws them; at most 1"},
    {.experiment = kTable3,
     .sentence = "The minimal frustum is visually better than the desired view.",
     .source = "section 4",
     .keys = "{*}: MIN-SM, misclassified",
     .over = "{*}: Ours-DV, misclassified",
     .most = 1,
     .reading = "ratio of errors; at most 1"},

    {.experiment = kFigures,
     .sentence = "After the rows' functions columns have nearly the same number of samples.",
     .source = "section 3.1, Figure 3",
     .keys = "{*}: samples of columns, variation after the rows",
     .most = 0.2,
     .reading = "standard deviation over the mean, without smoothing; at most 0.2"},
    {.experiment = kFigures,
     .sentence = "Warped, the view samples are better spread over the map.",
     .source = "section 3.1, Figure 5",
     .keys = "{*}: cells with view samples, after the columns",
     .over = "{*}: cells with view samples, before warping",
     .least = 1.05,
     .reading = "cells with samples over those before; at least 1.05"},
    {.experiment = kFigures,
     .sentence = "Cells without view samples almost disappear.",
     .source = "Figure 5",
     .keys = "{*}: cells with view samples, after the columns",
     .least = 75,
     .reading = "percent of the map with samples; at least 75",
     .quick = Quick::Decides},
};

// Of pictures by the share of the scene's map that they see. They are as many in quick runs, but fewer without the rooms.
constexpr Rule kRulesOfShares[] = {
    {.experiment = kFigures,
     .sentence = "Non-orthogonal warps give better results than RTW, where no rasterizer bends them.",
     .source = "sections 4 and 5",
     .keys = "{*of the map seen, * pictures}: Ours over Ours-DV",
     .over = "{*of the map seen, * pictures}: RTW over Ours-DV",
     .most = 1,
     .reading = "ratio of errors by rays; at most 1"},
    {.experiment = kFigures,
     .sentence = "The desired view performs better than warps when a small part of the scene is rendered.",
     .source = "section 4, Minimal Shadow Frustum",
     .keys = "{less than 5 % of the map seen, * pictures}: Ours over Ours-DV",
     .least = 1,
     .reading = "errors of warps over those of the desired view; at least 1"},
    {.experiment = kFigures,
     .sentence = "The minimal frustum performs better than warps when a small part of the scene is rendered.",
     .source = "section 4, Minimal Shadow Frustum",
     .keys = "{less than 5 % of the map seen, * pictures}: Ours over Ours-DV",
     .over = "{less than 5 % of the map seen, * pictures}: MIN-SM over Ours-DV",
     .least = 1,
     .reading = "errors of warps over those of the minimal frustum; at least 1"},
    {.experiment = kFigures,
     .sentence = "Warps perform better than the desired view when the camera renders a bigger part.",
     .source = "section 4, Minimal Shadow Frustum",
     .keys = "{more than 30 % of the map seen, * pictures}: Ours over Ours-DV",
     .most = 1,
     .reading = "errors of warps over those of the desired view; at most 1"},
    {.experiment = kFigures,
     .sentence = "Warps perform better than the minimal frustum when the camera renders a bigger part.",
     .source = "section 4, Minimal Shadow Frustum",
     .keys = "{more than 30 % of the map seen, * pictures}: Ours over Ours-DV",
     .over = "{more than 30 % of the map seen, * pictures}: MIN-SM over Ours-DV",
     .most = 1,
     .reading = "errors of warps over those of the minimal frustum; at most 1"},
    {.experiment = kFigures,
     .sentence = "In some situations the desired view is not sufficient.",
     .source = "section 4",
     .keys = "{*of the map seen, * pictures}: Ours over Ours-DV",
     .most = 0.9,
     .reading = "errors of warps over those of the desired view; somewhere at most 0.9",
     .judged = Judged::Least},
};

// Of the paper's methods with maps, by whole frames.
void addRankOfDesiredView(const Reproduction& of, std::vector<ReproducedClaim>& to)
{
    constexpr const char* kKey = "{*} over SM, frame with its plan";
    std::vector<Place> times = placesOf(kKey, of);
    if (times.empty()) return;
    std::erase_if(times, [](const Place& place) { return place.name == "NOW of lixel"; });
    times.push_back({"SM", 1, true});
    const auto ours = std::ranges::find(times, "Ours-DV", &Place::name);
    if (ours == times.end()) return;
    const auto faster = std::ranges::count_if(times, [&](const Place& p) { return p.value < ours->value; });
    Settled claim{.sentence = "The desired view alone is the third fastest method.",
                  .source = "section 4, Table 1",
                  .measured = "",
                  .reading = "frame times over SM's; two at most are faster",
                  .holds = faster <= 2,
                  .isOfTiming = true};
    for (const Place& place : times) tell(claim.measured, place.name, place.value);
    to.push_back(claimOf(claim, of));
}

// Somewhere another of the paper's maps has fewer errors.
void addMinimalFrustumIsNotBest(const Reproduction& of, std::vector<ReproducedClaim>& to)
{
    constexpr std::array kOthers{"SM", "RTW", "Ours", "Ours-DV"};
    const std::vector<Place> scenes = placesOf("{*}: MIN-SM, misclassified", of);
    if (scenes.empty()) return;
    Settled claim{.sentence = "The minimal frustum does not provide the best quality.",
                  .source = "section 4",
                  .measured = "",
                  .reading = "its errors over the fewest of SM, RTW, Ours and Ours-DV; more than 1",
                  .holds = true};
    for (const Place& scene : scenes) {
        double fewest = kAny;
        for (const char* other : kOthers)
            fewest =
                std::min(fewest, numberAt(fmt::format("{}: {}, misclassified", scene.name, other), of).value_or(kAny));
        claim.holds = claim.holds && scene.value > fewest;
        tell(claim.measured, scene.name, scene.value / fewest);
    }
    to.push_back(claimOf(claim, of));
}

// Of what all of the method takes off SM's errors, the share that the desired view alone does.
void addShareOfDesiredView(const Reproduction& of, std::vector<ReproducedClaim>& to)
{
    Settled claim{.sentence = "The desired view is the major part of the decrease of errors.",
                  .source = "section 4",
                  .measured = "",
                  .reading = "percent of the decrease from SM to Ours; at least 50",
                  .holds = true};
    for (const Place& sm : placesOf("{*of the map seen, * pictures}: SM over Ours-DV", of)) {
        const auto ours = numberAt(fmt::format("{}: Ours over Ours-DV", sm.name), of);
        if (!ours || sm.value <= *ours) continue; // no decrease
        const double share = 100 * (sm.value - 1) / (sm.value - *ours);
        claim.holds = claim.holds && share >= 50;
        tell(claim.measured, sm.name, share);
    }
    if (!claim.measured.empty()) to.push_back(claimOf(claim, of));
}

// A quick run with a handful of pictures decides nothing of them; in other runs their number is told.
void addOfShares(const Reproduction& of, std::vector<ReproducedClaim>& to)
{
    constexpr int kFewPictures = 5;
    for (Rule rule : kRulesOfShares) {
        if (std::ranges::all_of(placesOf(rule.keys, of), [](const Place& place) {
                return std::atoi(place.name.c_str() + place.name.rfind(", ") + 2) < kFewPictures;
            }))
            rule.quick = Quick::LeavesOpen, rule.whyOpen = "a handful of pictures";
        if (auto claim = settle(rule, of)) to.push_back(std::move(*claim));
    }
}

} // namespace

void addClaimsOfNow(std::string_view experiment, const Reproduction& of, std::vector<ReproducedClaim>& to)
{
    if (experiment == kTable1) addRankOfDesiredView(of, to);
    if (experiment == kTable3) addMinimalFrustumIsNotBest(of, to);
    settleAll(kRules, experiment, of, to);
    if (experiment == kFigures) addShareOfDesiredView(of, to), addOfShares(of, to);
}

} // namespace lixel::app
