// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

// Files appear whole or not at all: bytes go to a temporary file in the same folder, which is renamed at the end.
namespace lixel {

// what() is one line: "PATH: cannot be written: reason".
class OutputError : public std::runtime_error
{
public:
    OutputError(const std::filesystem::path& path, const std::string& reason);
};

// One file being written. Without commit() nothing is left of it, and a file that stood there before stays as it was.
// A link is followed; what is neither a file nor absent (a pipe, /dev/null) is written in place.
class AtomicFile
{
public:
    explicit AtomicFile(const std::filesystem::path& path); // throws OutputError
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    void write(std::string_view bytes); // throws OutputError
    void commit();                      // throws OutputError; nothing may be written after it

private:
    void discard() noexcept;
    [[noreturn]] void fail(int errorNumber);

    std::filesystem::path path_;   // as the caller knows it
    std::filesystem::path target_; // path_ with links followed
    std::filesystem::path temporary_;
    int descriptor_ = -1;
    int slot_ = -1; // into the table that removePendingFiles() reads; -1: written in place
};

void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes); // throws OutputError

// To be called before the file or folder is there: removePendingFiles() removes it too, a folder only when it is empty.
void removeWhenInterrupted(const std::filesystem::path& path);

// Makes the folder and those above it; throws OutputError. Nothing is wrong when it is there already.
void makeFolder(const std::filesystem::path& path);

// Files that take their places together, so that none of an earlier run stands beside those of a later one: they are written
// below path(), a hidden folder in `folder`. Without commit() nothing is left of them, and `folder` stays as it was.
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
    // another run. Throws OutputError.
    void commit();

private:
    std::filesystem::path folder_, path_;
};

// Removes the temporary files of every AtomicFile that is still open, in all threads, those that are staged, and what is named to
// removeWhenInterrupted(). Safe to call in a signal handler; the process must end after it.
void removePendingFiles() noexcept;

} // namespace lixel
