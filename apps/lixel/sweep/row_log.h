// SPDX-License-Identifier: MIT
#pragma once

#include "sweep/sweep_plan.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

// rows.jsonl, the file of a sweep's rows: a line with the plan and the share of it, then a line for each row, in the order in
// which they were measured. Lines are only ever added, a cell's all at once, so whatever ends the program costs a last cell
// that is not whole, and no other.
namespace lixel::app {

// The k-th of n parts of the cells, from 1: as many each, one after the other, so that what cells share is made once.
struct Shard
{
    std::size_t number = 1, of = 1;

    bool holds(std::size_t cell, std::size_t cells) const
    {
        return cell >= cells * (number - 1) / of && cell < cells * number / of;
    }
    friend bool operator==(const Shard&, const Shard&) = default;
};
std::string toString(const Shard& shard); // "2/3"

struct RowFile
{
    SweepPlan plan;
    std::vector<SweepCell> cells;
    Shard shard;
    std::map<std::size_t, std::string> rows; // of whole cells: by their number, lines without the break
    std::size_t bytes = 0;                   // up to the end of the last whole cell
    std::vector<std::string> doubled;        // keys of rows that stand there again
};

inline constexpr const char* kRowFileName = "rows.jsonl";

// Nothing where there is no such file, or not even its first line. Throws InputError where it is damaged, or has a row that the plan
// at its head does not.
std::optional<RowFile> readRowFile(const std::filesystem::path& path);

std::string headLine(const SweepPlan& plan, const Shard& shard); // with the break

// The file, open for more: locked, so that one process at a time is at it. Where nothing is begun, none is left behind.
class RowLog
{
public:
    explicit RowLog(const std::filesystem::path& path); // throws OutputError, UsageError where another process is at it
    RowLog(const RowLog&) = delete;
    RowLog& operator=(const RowLog&) = delete;
    ~RowLog();

    // One of these comes first: the file begins anew, or goes on after what readRowFile() gave. Throws OutputError.
    void begin(const SweepPlan& plan, const Shard& shard);
    void goOn(const RowFile& known);

    // The rows of a cell; they are on the disk when it returns. Throws OutputError.
    void append(const std::vector<std::string>& lines);

private:
    void truncate(std::size_t bytes);
    void write(std::string_view bytes);

    std::filesystem::path path_;
    int descriptor_ = -1;
};

} // namespace lixel::app
