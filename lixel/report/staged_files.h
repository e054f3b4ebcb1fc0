// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/write_file.h"

#include <filesystem>
#include <string>
#include <vector>

// Files of one run take their places together, or none does: none of an earlier run then stands beside those of a later one, and a
// run that breaks off, or cannot write one of them, leaves what was there. A process that is killed outright in the moment between
// leaves the older files under hidden names that end in ".old".
namespace lixel {

// Files anywhere.
class StagedFiles
{
public:
    StagedFiles() = default;
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;
    ~StagedFiles();

    // Where to write what is to stand at `target`: a hidden name beside it, or `target` itself where that is a device.
    std::filesystem::path add(const std::filesystem::path& target); // throws OutputError
    void commit();                                                  // throws OutputError

    // One that is written and the place that it takes.
    struct Move
    {
        std::filesystem::path from, to;
    };

private:
    std::vector<Move> moves_;
};

// Files below one folder: they are written below path(), a hidden folder in `folder`.
class StagedFolder
{
public:
    explicit StagedFolder(const std::filesystem::path& folder); // which must be there; throws OutputError
    StagedFolder(const StagedFolder&) = delete;
    StagedFolder& operator=(const StagedFolder&) = delete;
    ~StagedFolder();

    const std::filesystem::path& path() const { return path_; }
    void makeFolder(const std::string& name); // in it; throws OutputError

    // Files of `folder` itself that are replaced go first, and come last: a report never stands beside pictures of
    // another run. Devices are written to before anything else moves. Throws OutputError.
    void commit();

private:
    std::filesystem::path folder_, path_;
};

} // namespace lixel
