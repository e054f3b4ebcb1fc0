// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lixel {

// One number of a paper's experiment, measured again.
struct ReproducedNumber
{
    std::string key;  // within the experiment, e.g. "normal over focused, all lights"
    std::string unit; // "ratio", "percent of the picture", ...
    double ours = 0;
    std::optional<double> papers; // no value where the paper gives none
    std::string source;           // where in the paper
};

// A table of a paper, methods in its columns. Of every cell there is also how much more it is than the row's first, in percent.
struct ReproducedTable
{
    struct Column
    {
        std::string title, technique; // as the paper calls it; as it was typed
    };
    struct Cell
    {
        double ours = 0;
        std::optional<double> papers; // no value where the paper gives none
    };
    struct Row
    {
        std::string title;
        std::vector<Cell> cells; // one a column
    };
    std::string title, unit, source; // the unit is that of all cells; where in the paper
    std::vector<Column> columns;
    std::vector<Row> rows;
};

// Percent by which a cell is more than the first of its row; of ours, or of the paper's where it has both.
std::optional<double> percentMore(const ReproducedTable::Row& row, std::size_t column);
std::optional<double> papersPercentMore(const ReproducedTable::Row& row, std::size_t column);

// What is laid over a row's shaded picture.
enum class PictureLayer { None, Error, Boundary };

// Pictures beside each other, whole and enlarged, as papers show them.
struct PictureRow
{
    std::string title;                   // what the paper's figure shows there
    std::string scene, view, light;      // of the rows
    std::vector<std::string> techniques; // of the rows, as they were typed; from left to right
    int left = 0, top = 0, side = 0;     // the square that is enlarged, pixels from the picture's upper left
    PictureLayer layer = PictureLayer::None;
};

// What a paper says in words, in short, and what became of it.
struct ReproducedClaim
{
    std::string sentence, source;      // where in the paper
    std::string measured;              // numbers, and how the words were read
    std::optional<bool> holds = false; // no value: a quick run cannot decide it
    bool isOfTiming = false;           // depends on the clock and the machine
};

// Pictures of something else than a view: maps, and what maps are made from.
struct Plate
{
    std::string title, file; // a PNG in the report's folder
};
struct PlateRow
{
    std::string title;
    std::vector<Plate> plates; // from left to right
};

// Curves over one quantity, drawn over logarithmic axes: all values are above 0.
struct ReproducedChart
{
    struct Line
    {
        std::string label;
        std::vector<std::pair<double, double>> points; // (x, y), by growing x
    };
    std::string title, xLabel, unit; // the unit is that of y
    std::vector<Line> lines;
    bool isOfTiming = false; // depends on the clock and the machine
};

// One experiment of a paper, run again.
struct Reproduction
{
    std::string name, paper, question;
    bool isQuick = false;
    std::vector<std::pair<std::string, std::string>> parameters;
    std::vector<ReproducedNumber> numbers;
    std::vector<ReproducedNumber> timingNumbers; // those that depend on the clock and the machine
    std::vector<ReproducedTable> tables;
    std::vector<ReproducedChart> charts;
    std::vector<ReproducedClaim> claims;
    std::vector<PictureRow> figures; // of rows with pictures
    std::vector<PlateRow> plates;
    RunResults run; // what the numbers were made from
};

// "yes", "no", or that a quick run does not decide it.
std::string_view wordsFor(std::optional<bool> holds);

// The claims that depend on the clock, or the others, as a JSON array.
std::string toJson(const std::vector<ReproducedClaim>& claims, bool isOfTiming);

// JSON as toJson(RunResults) writes it, with `reproduction` beside `results`.
std::string toJson(const Reproduction& reproduction);

} // namespace lixel
