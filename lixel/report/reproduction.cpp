// SPDX-License-Identifier: MIT
#include "lixel/report/reproduction.h"

#include "lixel/report/json.h"
#include "lixel/report/json_document.h"

#include <nlohmann/json.hpp>

namespace lixel {
namespace {

using Json = nlohmann::json;

Json toJson(const std::vector<ReproducedNumber>& numbers)
{
    Json all = Json::array();
    for (const ReproducedNumber& n : numbers)
        all.push_back({{"key", n.key},
                       {"unit", n.unit},
                       {"ours", n.ours},
                       {"papers", n.papers ? Json(*n.papers) : Json(nullptr)},
                       {"source", n.source}});
    return all;
}

Json orNull(std::optional<double> value) { return value ? Json(*value) : Json(nullptr); }

// By how much a value is more than another; not of nothing.
std::optional<double> percentMoreThan(double base, double value)
{
    return base > 0 ? std::optional(100 * (value / base - 1)) : std::nullopt;
}

Json toJson(const ReproducedTable::Row& row)
{
    Json cells = Json::array();
    for (std::size_t i = 0; i < row.cells.size(); ++i)
        cells.push_back({{"ours", row.cells[i].ours},
                         {"percent_more", orNull(percentMore(row, i))},
                         {"papers", orNull(row.cells[i].papers)},
                         {"papers_percent_more", orNull(papersPercentMore(row, i))}});
    return {{"title", row.title}, {"cells", cells}};
}

Json toJson(const std::vector<ReproducedTable>& tables)
{
    Json all = Json::array();
    for (const ReproducedTable& table : tables) {
        Json columns = Json::array(), rows = Json::array();
        for (const auto& column : table.columns)
            columns.push_back({{"title", column.title}, {"technique", column.technique}});
        for (const auto& row : table.rows) rows.push_back(toJson(row));
        all.push_back({{"title", table.title},
                       {"unit", table.unit},
                       {"source", table.source},
                       {"columns", columns},
                       {"rows", rows}});
    }
    return all;
}

// The charts that depend on the clock, or the others.
Json toJson(const std::vector<ReproducedChart>& charts, bool isOfTiming)
{
    Json all = Json::array();
    for (const ReproducedChart& chart : charts) {
        if (chart.isOfTiming != isOfTiming) continue;
        Json lines = Json::array();
        for (const auto& line : chart.lines) lines.push_back({{"label", line.label}, {"points", line.points}});
        all.push_back({{"title", chart.title}, {"x_label", chart.xLabel}, {"unit", chart.unit}, {"lines", lines}});
    }
    return all;
}

const char* nameOf(PictureLayer layer)
{
    switch (layer) {
    case PictureLayer::Error: return "error";
    case PictureLayer::Boundary: return "boundary";
    case PictureLayer::None: break;
    }
    return "none";
}

Json toJson(const std::vector<PictureRow>& figures)
{
    Json all = Json::array();
    for (const PictureRow& f : figures)
        all.push_back({{"title", f.title},
                       {"scene", f.scene},
                       {"view", f.view},
                       {"light", f.light},
                       {"techniques", f.techniques},
                       {"layer", nameOf(f.layer)},
                       {"enlarged", {{"left", f.left}, {"top", f.top}, {"side", f.side}}}});
    return all;
}

Json toJson(const std::vector<PlateRow>& rows)
{
    Json all = Json::array();
    for (const PlateRow& row : rows) {
        Json plates = Json::array();
        for (const Plate& plate : row.plates) plates.push_back({{"title", plate.title}, {"file", plate.file}});
        all.push_back({{"title", row.title}, {"plates", plates}});
    }
    return all;
}

} // namespace

std::string_view wordsFor(std::optional<bool> holds)
{
    return !holds ? "not decided by this quick run" : *holds ? "yes" : "no";
}

std::string toJson(const std::vector<ReproducedClaim>& claims, bool isOfTiming)
{
    Json all = Json::array();
    for (const ReproducedClaim& claim : claims)
        if (claim.isOfTiming == isOfTiming)
            all.push_back({{"sentence", claim.sentence},
                           {"source", claim.source},
                           {"measured", claim.measured},
                           {"holds", claim.holds ? Json(*claim.holds) : Json(nullptr)}});
    return all.dump();
}

std::optional<double> percentMore(const ReproducedTable::Row& row, std::size_t column)
{
    return percentMoreThan(row.cells.front().ours, row.cells[column].ours);
}

std::optional<double> papersPercentMore(const ReproducedTable::Row& row, std::size_t column)
{
    const std::optional<double> base = row.cells.front().papers, of = row.cells[column].papers;
    return base && of ? percentMoreThan(*base, *of) : std::nullopt;
}

std::string toJson(const Reproduction& reproduction)
{
    Json parameters = Json::object();
    for (const auto& [name, value] : reproduction.parameters) parameters[name] = value;
    Json all = Json::parse(toJson(reproduction.run));
    all["reproduction"] = {{"name", reproduction.name},
                           {"paper", reproduction.paper},
                           {"question", reproduction.question},
                           {"quick", reproduction.isQuick},
                           {"parameters", parameters},
                           {"numbers", toJson(reproduction.numbers)},
                           {"tables", toJson(reproduction.tables)},
                           {"charts", toJson(reproduction.charts, false)},
                           {"claims", Json::parse(toJson(reproduction.claims, false))},
                           {"figures", toJson(reproduction.figures)},
                           {"plates", toJson(reproduction.plates)},
                           {"timing",
                            {{"numbers", toJson(reproduction.timingNumbers)},
                             {"charts", toJson(reproduction.charts, true)},
                             {"claims", Json::parse(toJson(reproduction.claims, true))}}}};
    return documentOf(all);
}

} // namespace lixel
