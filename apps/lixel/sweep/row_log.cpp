// SPDX-License-Identifier: MIT
#include "sweep/row_log.h"

#include "exit_code.h"
#include "lixel/report/sweep.h"
#include "lixel/report/write_file.h"
#include "lixel/scene/load.h"

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace lixel::app {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1; // of the file's form
constexpr int kLockTries = 20;
constexpr std::chrono::milliseconds kLockPause(100);

std::string reasonOf(int errorNumber) { return std::generic_category().message(errorNumber); }

[[noreturn]] void refuseLine(const fs::path& path, std::size_t line, const std::string& what)
{
    throw InputError(fmt::format("{}: line {}: {}", path.string(), line, what));
}

RowFile readHead(const fs::path& path, std::string_view line)
{
    const Json head = Json::parse(line, nullptr, false);
    const auto number = [&](const char* name) {
        return head.is_object() && head.contains(name) && head[name].is_number_unsigned()
                   ? head[name].get<std::size_t>()
                   : 0;
    };
    if (number("lixel_study_rows") != kVersion) refuseLine(path, 1, "expected the head of a study's rows");
    RowFile file;
    file.shard = {number("shard"), number("shards")};
    const auto plan = head.contains("plan") ? readPlan(head["plan"].dump()) : std::nullopt;
    if (!plan || file.shard.number < 1 || file.shard.number > file.shard.of)
        refuseLine(path, 1, "expected the head of a study's rows");
    file.plan = *plan;
    file.cells = plan->cells();
    return file;
}

// Which cell has which row.
std::vector<std::size_t> cellOfRows(const std::vector<SweepCell>& cells)
{
    std::vector<std::size_t> of;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) of.insert(of.end(), cells[cell].rows, cell);
    return of;
}

} // namespace

std::string toString(const Shard& shard) { return fmt::format("{}/{}", shard.number, shard.of); }

std::string headLine(const SweepPlan& plan, const Shard& shard)
{
    return fmt::format("{{\"lixel_study_rows\":{},\"shard\":{},\"shards\":{},\"plan\":{}}}\n", kVersion, shard.number,
                       shard.of, toJson(plan));
}

std::optional<RowFile> readRowFile(const fs::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return std::nullopt;
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const std::size_t headEnd = text.find('\n');
    if (headEnd == text.npos) return std::nullopt;
    RowFile file = readHead(path, std::string_view(text).substr(0, headEnd));
    file.bytes = headEnd + 1;

    const std::vector<std::size_t> cellOf = cellOfRows(file.cells);
    std::vector<std::string> cellLines; // of the cell that is being read
    std::size_t lineNumber = 2;
    for (std::size_t begin = headEnd + 1;; ++lineNumber) {
        const std::size_t end = text.find('\n', begin);
        if (end == text.npos) return file; // the rest, if any, was being written when the program ended
        const std::string line = text.substr(begin, end - begin);
        begin = end + 1;
        const auto name = nameOfSweepRow(line);
        if (!name) {
            if (text.find('\n', begin) == text.npos) return file; // after the machine itself stopped
            refuseLine(path, lineNumber, "expected a row");
        }
        if (name->number >= cellOf.size()) refuseLine(path, lineNumber, "the plan has no such row: " + name->key);
        const SweepCell& cell = file.cells[cellOf[name->number]];
        if (name->key != file.plan.keyOf(cell, name->number - cell.firstRow))
            refuseLine(path, lineNumber, "is another row than the plan has there: " + name->key);
        if (name->number != cell.firstRow + cellLines.size())
            refuseLine(path, lineNumber, "is out of turn: " + name->key);
        cellLines.push_back(line);
        if (cellLines.size() < cell.rows) continue;
        for (std::size_t i = 0; i < cell.rows; ++i)
            if (!file.rows.emplace(cell.firstRow + i, cellLines[i]).second)
                file.doubled.push_back(file.plan.keyOf(cell, i));
        cellLines.clear();
        file.bytes = begin;
    }
}

RowLog::RowLog(const fs::path& path) : path_(path)
{
    descriptor_ = open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw OutputError(path, reasonOf(errno));
    // One that was killed keeps its lock for a moment.
    for (int tries = 0; tries < kLockTries; ++tries) {
        if (tries > 0) std::this_thread::sleep_for(kLockPause);
        if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
            return; // some file systems have no locks
    }
    close(descriptor_);
    throw UsageError(path.string() + ": another lixel is at work on it");
}

RowLog::~RowLog()
{
    struct stat status
    {
    };
    if (fstat(descriptor_, &status) == 0 && status.st_size == 0) unlink(path_.c_str());
    close(descriptor_);
}

void RowLog::begin(const SweepPlan& plan, const Shard& shard)
{
    truncate(0);
    write(headLine(plan, shard));
}

void RowLog::goOn(const RowFile& known) { truncate(known.bytes); }

void RowLog::truncate(std::size_t bytes)
{
    if (ftruncate(descriptor_, off_t(bytes)) != 0) throw OutputError(path_, reasonOf(errno));
}

void RowLog::append(const std::vector<std::string>& lines)
{
    std::string all;
    for (const std::string& line : lines) all.append(line).append("\n");
    write(all);
}

void RowLog::write(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw OutputError(path_, reasonOf(errno));
        bytes.remove_prefix(std::size_t(written));
    }
    if (fdatasync(descriptor_) != 0 && errno == EIO) throw OutputError(path_, reasonOf(errno));
}

} // namespace lixel::app
