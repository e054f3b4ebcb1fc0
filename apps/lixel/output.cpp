// SPDX-License-Identifier: MIT
#include "output.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace fs = std::filesystem;

namespace lixel::app {
namespace {

[[noreturn]] void failPrinting(int errorNumber)
{
    throw OutputError("standard output", std::generic_category().message(errorNumber));
}

} // namespace

void expectWritable(const fs::path& path)
{
    // A pipe that is opened and closed would end its reader.
    if (path != "-" && !placeOf(path).isInPlace) AtomicFile discarded(path);
}

OutputFolder::OutputFolder(const fs::path& path) : path_(path)
{
    std::error_code error;
    for (fs::path above = path; !above.empty() && !fs::exists(above, error); above = above.parent_path())
        made_.push_back(above);
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) removeWhenInterrupted(*folder);
    makeFolder(path);
}

OutputFolder::~OutputFolder()
{
    std::error_code stays; // a folder with something in it cannot be removed
    for (const fs::path& folder : made_) fs::remove(folder, stays);
}

ReportFolder::ReportFolder(const std::filesystem::path& path, bool withPictures) : folder_(path), staged_(path)
{
    if (withPictures) {
        pictures_.emplace(path / "pictures");
        expectWritable(path / "pictures" / "any.png");
        staged_.makeFolder("pictures");
    }
    for (const char* name : {"results.json", "report.html"}) expectWritable(path / name);
}

bool isSameOutput(const fs::path& one, const fs::path& other)
{
    if (one == "-" || other == "-") return one == other;
    std::error_code error;
    if (fs::exists(one, error) && !fs::is_regular_file(one, error)) return false;
    const fs::path first = fs::weakly_canonical(fs::absolute(one), error);
    return first == fs::weakly_canonical(fs::absolute(other), error) || fs::equivalent(one, other, error);
}

void writeOrPrint(const fs::path& path, std::string_view bytes)
{
    if (path != "-") return writeFileAtomically(path, bytes);
    errno = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) failPrinting(errno);
    finishPrinting();
}

void finishPrinting()
{
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) failPrinting(errno != 0 ? errno : EIO);
}

} // namespace lixel::app
