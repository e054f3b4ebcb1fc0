// SPDX-License-Identifier: MIT
#include "experiments/scene_optimised_table1_numbers.h"

#include <array>

#include <fmt/format.h>

namespace lixel::app {
namespace {

constexpr double kWorstShare = 0.1;
constexpr const char* kSource = "Table 1";

// As printed: misclassified pixels of Optimal, Focused, LiSPSM, Plane and Normal. The text calls them averages; they are sums,
// as an average of 1.9 million pixels does not fit into a picture of 750x750.
constexpr double kPapersLights = 500, kPapersWorstLights = 50, kPapersPixels = 750 * 750;
constexpr std::array<double, kPapersColumns> kPapersAll{1886057, 2407686, 2929613, 7828974, 5405579};
constexpr std::array<std::array<double, kPapersColumns>, kPapersColumns> kPapersWorst{{
    {304839, 403529, 324559, 500413, 1146830},
    {263638, 485088, 354289, 373324, 1203575},
    {253331, 422387, 377762, 408887, 1068285},
    {170056, 217869, 197196, 1242144, 692796},
    {272953, 448302, 338566, 521885, 1308651},
}};

// Sums as means, the paper's sums beside them where it has the row.
ReproducedTable::Row rowOf(std::string title, const std::vector<double>& sums, std::size_t lights,
                           const std::array<double, kPapersColumns>* papers, double papersLights)
{
    ReproducedTable::Row row{std::move(title), {}};
    for (std::size_t column = 0; column < sums.size(); ++column) {
        ReproducedTable::Cell& cell = row.cells.emplace_back();
        cell.ours = lights > 0 ? sums[column] / double(lights) : 0;
        if (papers && column < kPapersColumns) cell.papers = (*papers)[column] / papersLights;
    }
    return row;
}

} // namespace

ReproducedTable tableOf(std::vector<ReproducedTable::Column> columns, const ComparableErrors& counted)
{
    const RankedSums sums = rankedSums(counted.errors, kWorstShare);
    ReproducedTable table{
        "Number of misclassified pixels", "misclassified pixels a picture", kSource, std::move(columns), {}};
    table.rows.push_back(rowOf("using all data", sums.all, sums.cases, &kPapersAll, kPapersLights));
    for (std::size_t by = 0; by < sums.worst.size(); ++by)
        table.rows.push_back(rowOf(fmt::format("worst 10 % by {}", table.columns[by].title), sums.worst[by],
                                   sums.worstCases, by < kPapersColumns ? &kPapersWorst[by] : nullptr,
                                   kPapersWorstLights));
    return table;
}

std::vector<ReproducedNumber> numbersOf(const ReproducedTable& table, const ComparableErrors& counted, double pixels)
{
    const ReproducedTable::Row& all = table.rows.front();
    std::vector<ReproducedNumber> numbers{{"Optimal, misclassified of the picture", "percent",
                                           100 * all.cells[kOptimal].ours / pixels,
                                           100 * kPapersAll[kOptimal] / kPapersLights / kPapersPixels,
                                           "Table 1, using all data, a sum over 500 pictures"}};
    for (std::size_t column = 0; column < all.cells.size(); ++column) {
        if (column == kFocused) continue;
        const auto fewer = [&](double focused, double of) { return 100 * (1 - of / focused); };
        const ReproducedTable::Cell& focused = all.cells[kFocused];
        const ReproducedTable::Cell& of = all.cells[column];
        numbers.push_back({fmt::format("{}, fewer errors than Focused", table.columns[column].title), "percent",
                           fewer(focused.ours, of.ours),
                           of.papers ? std::optional(fewer(*focused.papers, *of.papers)) : std::nullopt,
                           "Table 1, using all data"});
    }
    for (std::size_t column = 0; column < counted.refused.size(); ++column)
        if (counted.refused[column] > 0)
            numbers.push_back({fmt::format("{}, refused, counted as Focused", table.columns[column].title), "lights",
                               double(counted.refused[column]), std::nullopt, "the paper has none"});
    return numbers;
}

} // namespace lixel::app
