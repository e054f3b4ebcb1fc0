// SPDX-License-Identifier: MIT
#include "experiments/claim_rules.h"
#include "experiments/claims_of_papers.h"

#include <fmt/format.h>

// C. Pagot, J. Comba, M. Oliveira. Multiple-Depth Shadow Maps. 2004. PCF(k,n): k taps over n depths.
namespace lixel::app {
namespace {

constexpr const char *kTable1 = "multiple-depth-table1", *kFigures = "multiple-depth-figures",
                     *kCost = "multiple-depth-cost";

constexpr Rule kRules[] = {
    {.experiment = kTable1,
     .sentence = "The multiple-depth test gives a larger range of shades than the conventional one.",
     .source = "section 1, Figure 3",
     .keys = "PCF({*},2)",
     .over = "PCF({*},1)",
     .least = 1.05,
     .reading = "shades of two depths over those of one, by the number of taps; at least 1.05",
     .quick = Quick::Decides},
    {.experiment = kTable1,
     .sentence = "PCF(9,2) has 11.7 % more shades than PCF(16,1), by 56 % of its samples.",
     .source = "section 4.2",
     .keys = "PCF(9,2)",
     .over = "PCF(16,1)",
     .least = 1.117,
     .reading = "shades of 9 taps over two depths over those of 16 over one; at least 1.117",
     .quick = Quick::CanOnlyBearOut},

    {.experiment = kFigures,
     .sentence = "Several depths give better estimates of shadow percentages.",
     .source = "abstract, section 1",
     .keys = "{*} receivers, against the pixel's area: depths(3)+pcf(9)",
     .over = "{*} receivers, against the pixel's area: pcf(9)",
     .most = 1,
     .reading = "RMSE to the pixel's lit share of three depths over that of one, nine taps; at most 1"},
    {.experiment = kFigures,
     .sentence = "Multiple-depth maps significantly reduce aliasing.",
     .source = "section 1",
     .keys = "{*}, depths(3): RMSE over that of PCF(16,1), against the 4x4 footprint of PCF(16,1)",
     .over = "{*}, pcf(1): RMSE over that of PCF(16,1), against the 4x4 footprint of PCF(16,1)",
     .most = 0.9,
     .reading = "RMSE to a footprint of 4x4 lixels of three depths over that of one, one tap; at most 0.9"},
    {.experiment = kFigures,
     .sentence = "Percentage closer filtering significantly reduces aliasing.",
     .source = "section 2.2",
     .keys = "{*}, pcf(1): RMSE over that of PCF(16,1), against the 4x4 footprint of PCF(16,1)",
     .least = 1 / 0.9,
     .reading = "RMSE to a footprint of 4x4 lixels of one tap over that of 16; at least 1.11"},
    {.experiment = kFigures,
     .sentence = "Transitions of PCF(9,2) and PCF(9,3) are similar to that of PCF(16,1).",
     .source = "section 1, Figure 1",
     .keys = "overview, {*}: width of the transition over that of PCF(16,1)",
     .least = 0.8,
     .most = 1.25,
     .reading = "ratio of widths; 0.8 to 1.25"},
    {.experiment = kFigures,
     .sentence = "From PCF(16,1) to PCF(9,2) quality can be expected to improve by 11.7 %.",
     .source = "section 4.2",
     .keys = "{*, depths(2,m*)}+pcf(9): RMSE over that of PCF(16,1), against the 4x4 footprint of PCF(16,1)",
     .most = 0.883,
     .reading = "ratio of RMSE; the best of receivers and rules to choose depths at most 0.883",
     .judged = Judged::Least},
    {.experiment = kFigures,
     .sentence = "On a plane three depths and 3x3 taps are comparable to one depth and 4x4.",
     .source = "section 5, Figure 6",
     .keys = "planar, {depths(3*)+pcf(9)}: RMSE over that of PCF(16,1), against the 4x4 footprint of PCF(16,1)",
     .most = 1.1,
     .reading = "RMSE over that of PCF(16,1), of the best rule to choose depths; at most 1.1",
     .judged = Judged::Least},
    {.experiment = kFigures,
     .sentence = "On a plane three depths and 2x2 taps are comparable to one depth and 3x3.",
     .source = "section 5, Figure 6",
     .keys = "planar, {depths(3)+pcf(4)}: RMSE over that of PCF(9,1), against the 3x3 footprint of PCF(9,1)",
     .most = 1.1,
     .reading = "RMSE over that of PCF(9,1); at most 1.1"},
    {.experiment = kFigures,
     .sentence = "On curved surfaces three depths and 3x3 taps are very similar to one depth and 4x4.",
     .source = "section 5, Figure 7",
     .keys = "curved, {depths(3*)+pcf(9)}: RMSE over that of PCF(16,1), against the 4x4 footprint of PCF(16,1)",
     .most = 1.1,
     .reading = "RMSE over that of PCF(16,1), of the best rule to choose depths; at most 1.1",
     .judged = Judged::Least},
    {.experiment = kFigures,
     .sentence = "On curved surfaces two depths and 3x3 taps are very similar to one depth and 4x4.",
     .source = "section 5, Figure 7",
     .keys = "curved, {depths(2*)+pcf(9)}: RMSE over that of PCF(16,1), against the 4x4 footprint of PCF(16,1)",
     .most = 1.1,
     .reading = "RMSE over that of PCF(16,1), of the best rule to choose depths; at most 1.1",
     .judged = Judged::Least},
    {.experiment = kFigures,
     .sentence = "On curved surfaces the transition of three depths is closer to PCF(16,1)'s than that of two.",
     .source = "section 5, Figure 7",
     .keys = "close-up, depths(3)+pcf(9): width of the transition over that of PCF(16,1)",
     .over = "close-up, depths(2,max)+pcf(9): width of the transition over that of PCF(16,1)",
     .least = 1.05,
     .reading = "width with three over that with two, both thinner than it; at least 1.05"},
    {.experiment = kFigures,
     .sentence = "A depth can be satisfactorily represented by 16 bits.",
     .source = "section 7",
     .keys = "{*} receivers, against the pixel's area: depths(4,bits=16)+pcf(9)",
     .over = "{*} receivers, against the pixel's area: depths(4)+pcf(9)",
     .most = 1.01,
     .reading = "RMSE of 16 bits over that of 32; at most 1.01",
     .quick = Quick::Decides},

    {.experiment = kCost,
     .sentence = "Multiple depths cost little more.",
     .source = "section 1",
     .keys = "nine taps of two depths, chosen anew, over nine of one",
     .most = 1.25,
     .reading = "ratio of times, the picture's side twice the map's; at most 1.25"},
    {.experiment = kCost,
     .sentence = "A kernel of k taps scales the cost of texture and test by k.",
     .source = "section 4.1, equation 1",
     .keys = "equation 1, n = 1: farthest of a time from the line",
     .most = 10,
     .reading = "percent of the time of 25 taps; at most 10"},
    {.experiment = kCost,
     .sentence = "Choosing the maximum or minimum is the cheapest way.",
     .source = "section 4.3",
     .keys = "equation 2, n = 2: choosing depths, a lixel and neighbour",
     .over = "equation 2, n = 4: choosing depths, a lixel and neighbour",
     .most = 1,
     .reading = "time of the maximum over that of sorting for four; at most 1"},
    {.experiment = kCost,
     .sentence = "In static scenes choosing depths costs nothing, and PCF(9,2) is cheaper than PCF(16,1).",
     .source = "section 4.4",
     .keys = "{lambda *}: PCF(9,2) of maps that are kept",
     .over = "{lambda *}: PCF(16,1)",
     .most = 1,
     .reading = "ratio of times, by sides of the picture over those of the map; at most 1"},
    {.experiment = kCost,
     .sentence = "A multiple-depth test is slightly more expensive than a conventional one.",
     .source = "section 6",
     .keys = "nine taps of two depths over nine of one",
     .most = 1.25,
     .reading = "ratio of times; at most 1.25"},
    {.experiment = kCost,
     .sentence = "Choosing depths has a fixed cost, whatever the picture.",
     .source = "section 6",
     .keys = "choosing depths, the slowest picture over the fastest",
     .most = 1.25,
     .reading = "ratio of times; at most 1.25"},
    {.experiment = kCost,
     .sentence = "The fragments of a scene can be several times its pixels.",
     .source = "section 6",
     .keys = "{*, *}: fragments a pixel, forward",
     .least = 3,
     .reading = "without a depth test; somewhere at least 3",
     .judged = Judged::Most},
    {.experiment = kCost,
     .sentence = "More than 1.28 fragments a pixel are frequent for scenes of moderate depth complexity.",
     .source = "section 6",
     .keys = "{*, *}: fragments a pixel, forward",
     .least = 1.28,
     .reading = "without a depth test; at least 1.28"},
    {.experiment = kCost,
     .sentence = "With deferred shading and a map as large as the screen, PCF(9,2) is never cheaper than PCF(16,1).",
     .source = "section 6, equation 6",
     .keys = "{lambda 1.000}: PCF(9,2) and its depths",
     .over = "{lambda 1.000}: PCF(16,1)",
     .least = 1,
     .reading = "ratio of times; at least 1"},
    {.experiment = kCost,
     .sentence = "A screen of 656x656 suffices for a map of 512x512.",
     .source = "section 6, equation 6",
     .keys = "equation 6: side of a square screen over a map of 512",
     .most = 656,
     .reading = "pixels a side by the paper's own equation, which is of areas; at most 656",
     .quick = Quick::Decides},
};

// All outcomes of all choices, and never more.
void addShadesSeen(const Reproduction& of, std::vector<ReproducedClaim>& to)
{
    int all = 0, seen = 0, more = 0;
    for (const ReproducedNumber& n : of.numbers)
        if (n.papers && n.key.starts_with("PCF(")) ++all, seen += n.ours == *n.papers, more += n.ours > *n.papers;
    if (all == 0) return;
    to.push_back(claimOf({.sentence = "A kernel of k taps over n depths has nk + 1 outcomes.",
                          .source = "section 4.2, Table 1",
                          .measured = fmt::format("{} of {} entries are seen whole in pictures, {} has more", seen, all,
                                                  more == 0 ? "none" : fmt::format("{}", more)),
                          .reading = "",
                          .holds = seen == all,
                          .quick = more > 0 ? Quick::Decides : Quick::CanOnlyBearOut,
                          .whyOpen = "one small picture need not show every shade"},
                         of));
}

// Where the two cross; the paper's own example, q = 9 and r = 7.
void addBreakEven(const Reproduction& of, std::vector<ReproducedClaim>& to)
{
    const auto crossing = numberAt("measured break-even, f / (h w)", of);
    const std::vector<Place> tried = placesOf("lambda {*}: PCF(16,1)", of);
    if (tried.empty()) return;
    to.push_back(
        claimOf({.sentence = "PCF(9,2) costs less than PCF(16,1) once f > 1.28 times the lixels.",
                 .source = "section 6, equation 5",
                 .measured = crossing ? shortly(*crossing)
                                      : fmt::format("not up to pictures of {} times the map's side", tried.back().name),
                 .reading = "measured break-even in fragments a lixel; at most 1.28",
                 .holds = crossing && *crossing <= 1.28,
                 .isOfTiming = true},
                of));
}

} // namespace

void addClaimsOfMultipleDepth(std::string_view experiment, const Reproduction& of, std::vector<ReproducedClaim>& to)
{
    if (experiment == kTable1) addShadesSeen(of, to);
    if (experiment == kCost) addBreakEven(of, to);
    settleAll(kRules, experiment, of, to);
}

} // namespace lixel::app
