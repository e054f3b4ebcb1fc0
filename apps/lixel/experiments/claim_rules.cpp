// SPDX-License-Identifier: MIT
#include "experiments/claim_rules.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

namespace lixel::app {
namespace {

constexpr double kNear = 0.05; // of a bound

bool matches(std::string_view glob, std::string_view text)
{
    if (glob.empty()) return text.empty();
    if (glob.front() != '*') {
        const bool isAlike = !text.empty() && (glob.front() == '?' || glob.front() == text.front());
        return isAlike && matches(glob.substr(1), text.substr(1));
    }
    for (std::size_t taken = 0; taken <= text.size(); ++taken)
        if (matches(glob.substr(1), text.substr(taken))) return true;
    return false;
}

// A pattern's three parts; without braces all of it stands before them.
struct Pattern
{
    std::string_view before, within, after;
    bool hasBraces = false;

    explicit Pattern(std::string_view all) : before(all)
    {
        const std::size_t open = all.find('{'), close = all.find('}');
        if (open == std::string_view::npos || close == std::string_view::npos) return;
        before = all.substr(0, open);
        within = all.substr(open + 1, close - open - 1);
        after = all.substr(close + 1);
        hasBraces = true;
    }

    std::optional<std::string_view> placeIn(std::string_view key) const
    {
        if (key.size() < before.size() + after.size() || !key.starts_with(before) || !key.ends_with(after))
            return std::nullopt;
        const std::string_view place = key.substr(before.size(), key.size() - before.size() - after.size());
        return matches(within, place) ? std::optional(place) : std::nullopt;
    }
};

enum class Verdict { No, Open, Yes };

bool isNear(double value, double bound)
{
    return std::isfinite(bound) && std::abs(value - bound) < kNear * std::abs(bound);
}

Verdict verdictOf(double value, const Rule& rule, bool isQuick)
{
    if (isQuick && rule.quick == Quick::NearIsOpen && (isNear(value, rule.least) || isNear(value, rule.most)))
        return Verdict::Open;
    return value >= rule.least && value <= rule.most ? Verdict::Yes : Verdict::No;
}

// Of one number over another; a place without the other, or with nothing there, has no ratio.
std::vector<Place> ratiosOf(const Rule& rule, const Reproduction& reproduction)
{
    std::vector<Place> values = placesOf(rule.keys, reproduction);
    if (!rule.over) return values;
    const bool isOfPlaces = Pattern(rule.over).hasBraces;
    const std::vector<Place> others = placesOf(rule.over, reproduction);
    std::vector<Place> ratios;
    for (Place& value : values)
        for (const Place& other : others)
            if ((!isOfPlaces || other.name == value.name) && other.value > 0)
                ratios.push_back({value.name, value.value / other.value, value.isOfTiming || other.isOfTiming});
    return ratios;
}

bool leavesOpen(Quick quick, bool holds)
{
    return quick == Quick::LeavesOpen || (quick == Quick::CanOnlyBearOut && !holds) ||
           (quick == Quick::CanOnlyRefute && holds);
}

} // namespace

std::vector<Place> placesOf(std::string_view pattern, const Reproduction& reproduction)
{
    const Pattern wanted(pattern);
    std::vector<Place> places;
    const auto take = [&](std::string_view key, double value, bool isOfTiming) {
        if (const auto place = wanted.placeIn(key); place && std::isfinite(value))
            places.push_back({std::string(*place), value, isOfTiming});
    };
    for (const ReproducedNumber& n : reproduction.numbers) take(n.key, n.ours, false);
    for (const ReproducedNumber& n : reproduction.timingNumbers) take(n.key, n.ours, true);
    for (const ReproducedTable& table : reproduction.tables)
        for (const ReproducedTable::Row& row : table.rows)
            for (std::size_t i = 0; i < row.cells.size(); ++i)
                take(fmt::format("{}: {}", row.title, table.columns[i].title), row.cells[i].ours, false);
    return places;
}

std::optional<double> numberAt(std::string_view key, const Reproduction& reproduction)
{
    const std::vector<Place> places = placesOf(key, reproduction);
    return places.empty() ? std::nullopt : std::optional(places.front().value);
}

std::string shortly(double value)
{
    const double size = std::abs(value);
    if (!std::isfinite(value) || size == 0) return fmt::format("{:g}", value);
    const double step = std::pow(10, std::floor(std::log10(size)) - 2), rounded = step * std::round(value / step);
    const int digits = std::max(0, int(-std::floor(std::log10(step) + 1e-9)));
    std::string text = fmt::format("{:.{}f}", rounded, digits);
    if (digits > 0) text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

void tell(std::string& list, std::string_view place, double value)
{
    const bool isOneWord = place.find(' ') == place.npos && !(!place.empty() && std::isdigit(place.back()));
    const char* const between = place.empty() ? "" : isOneWord ? " " : ": ";
    list += fmt::format("{}{}{}{}", list.empty() ? "" : "; ", place, between, shortly(value));
}

ReproducedClaim claimOf(const Settled& settled, const Reproduction& reproduction)
{
    ReproducedClaim claim{settled.sentence, settled.source, settled.measured, settled.holds, settled.isOfTiming};
    if (!settled.reading.empty()) claim.measured += fmt::format(" ({})", settled.reading);
    if (reproduction.isQuick && leavesOpen(settled.quick, settled.holds)) {
        claim.holds = std::nullopt;
        claim.measured += fmt::format("; open: {}", settled.whyOpen);
    }
    return claim;
}

std::optional<ReproducedClaim> settle(const Rule& rule, const Reproduction& reproduction)
{
    std::vector<Place> places = ratiosOf(rule, reproduction);
    if (places.empty()) return std::nullopt;
    const auto byValue = [](const Place& a, const Place& b) { return a.value < b.value; };
    if (rule.judged == Judged::Least) places = {*std::ranges::min_element(places, byValue)};
    if (rule.judged == Judged::Most) places = {*std::ranges::max_element(places, byValue)};
    Verdict all = Verdict::Yes;
    Settled settled{rule.sentence, rule.source, "", rule.reading};
    for (const Place& place : places) {
        all = std::min(all, verdictOf(place.value, rule, reproduction.isQuick));
        settled.isOfTiming = settled.isOfTiming || place.isOfTiming;
        tell(settled.measured, place.name, place.value);
    }
    settled.holds = all == Verdict::Yes;
    settled.quick = all == Verdict::Open ? Quick::LeavesOpen : rule.quick;
    settled.whyOpen = rule.whyOpen;
    return claimOf(settled, reproduction);
}

void settleAll(std::span<const Rule> rules, std::string_view experiment, const Reproduction& reproduction,
               std::vector<ReproducedClaim>& claims)
{
    for (const Rule& rule : rules)
        if (experiment == rule.experiment)
            if (auto claim = settle(rule, reproduction)) claims.push_back(std::move(*claim));
}

} // namespace lixel::app
