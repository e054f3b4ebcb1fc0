// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/interruption.h"

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
    OutputError(const std::filesystem::path& path, int errorNumber);
};

// Where what is written to `path` goes. A link is followed; what is neither a file nor absent (a pipe, /dev/null) is written in place.
struct OutputPlace
{
    std::filesystem::path target; // with links followed
    bool isInPlace = false;
};
OutputPlace placeOf(const std::filesystem::path& path); // throws OutputError, for a folder too

// A hidden name beside `target` that no other file of this process has. It says at its end what it is for.
std::filesystem::path temporaryName(const std::filesystem::path& target, std::string_view ending = "part");

// One file being written. Without commit() nothing is left of it, and a file that stood there before stays as it was.
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

    std::filesystem::path path_; // as the caller knows it
    OutputPlace place_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
    PendingName pending_; // holds nothing where it is written in place
};

void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes); // throws OutputError

// Makes the folder and those above it; throws OutputError. Nothing is wrong when it is there already.
void makeFolder(const std::filesystem::path& path);

} // namespace lixel
