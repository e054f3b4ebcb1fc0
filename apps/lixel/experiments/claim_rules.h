// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/reproduction.h"

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// How a sentence of a paper is held against the numbers of an experiment. Papers rarely give bounds; those here are our reading of
// their words, and are said beside what was measured.
namespace lixel::app {

inline constexpr double kAny = std::numeric_limits<double>::infinity();

// What a quick run, with its few pixels, pictures and frames, can say of a claim. Full runs decide all.
enum class Quick {
    Decides,
    NearIsOpen,     // unless what it measures lies within a twentieth of a bound
    CanOnlyBearOut, // it is the harder case: where it does not hold, the full run may
    CanOnlyRefute,  // it is the easier case
    LeavesOpen
};

// Which of the numbers lie between the bounds: every one, or the least or the greatest.
enum class Judged { All, Least, Most };

// Keys of numbers are patterns: literal, but within one pair of braces, where * stands for anything and ? for a letter. What is within the braces is
// told as the place of each number. A cell of a table has the key "ROW: COLUMN".
struct Rule
{
    const char *experiment = "", *sentence = "", *source = "";
    const char* keys = "";
    const char* over = nullptr; // each number over this one: over that of the same place, where it has braces
    double least = -kAny, most = kAny;
    const char* reading = ""; // what the numbers are, and the bounds
    Judged judged = Judged::All;
    Quick quick = Quick::NearIsOpen;
    const char* whyOpen = "too near a bound for a quick run"; // said where a quick run leaves the claim open
};

// Nothing where the run has none of the numbers.
std::optional<ReproducedClaim> settle(const Rule& rule, const Reproduction& reproduction);
void settleAll(std::span<const Rule> rules, std::string_view experiment, const Reproduction& reproduction,
               std::vector<ReproducedClaim>& claims);

// ---- for claims that no rule can tell

struct Place
{
    std::string name;
    double value = 0;
    bool isOfTiming = false;
};
std::vector<Place> placesOf(std::string_view pattern, const Reproduction& reproduction);
std::optional<double> numberAt(std::string_view key, const Reproduction& reproduction);

// "bunnies 1.53; 100x100: 2810": three digits, none of them in an exponent.
std::string shortly(double value);
void tell(std::string& list, std::string_view place, double value);

// A claim about these numbers: their list, the reading in parentheses. A quick run that leaves it open says why.
struct Settled
{
    const char *sentence, *source;
    std::string measured;
    std::string reading;
    bool holds = false, isOfTiming = false;
    Quick quick = Quick::Decides;
    const char* whyOpen = "";
};
ReproducedClaim claimOf(const Settled& settled, const Reproduction& reproduction);

} // namespace lixel::app
