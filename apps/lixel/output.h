// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/staged_files.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Where results go. Whether they can go there is asked before the work begins, not after it.
namespace lixel::app {

// Throws OutputError when a file cannot be written there; "-", standard output, always can. Leaves nothing behind.
void expectWritable(const std::filesystem::path& path);

// A folder with those above it: made now, and taken away again at the end where nothing was put into them.
class OutputFolder
{
public:
    explicit OutputFolder(const std::filesystem::path& path); // throws OutputError
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;
    ~OutputFolder();

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    std::vector<std::filesystem::path> made_; // from the innermost
};

// The folder of the report and what it will hold, asked for before the work begins. All is written to writeTo(), and takes its
// place at the end: whoever breaks off keeps the report that was there.
class ReportFolder
{
public:
    ReportFolder(const std::filesystem::path& path, bool withPictures); // throws OutputError

    const std::filesystem::path& writeTo() const { return staged_.path(); }
    void finish() { staged_.commit(); } // throws OutputError

private:
    OutputFolder folder_;
    StagedFolder staged_;
    std::optional<OutputFolder> pictures_;
};

// Whether two names are of one file, which cannot hold both; "-" is the same as itself. A device takes anything.
bool isSameOutput(const std::filesystem::path& one, const std::filesystem::path& other);

// To a file, whole or not at all, or to standard output for "-". Throws OutputError.
void writeOrPrint(const std::filesystem::path& path, std::string_view bytes);

// What has been printed is out; throws OutputError when it is not.
void finishPrinting();

} // namespace lixel::app
