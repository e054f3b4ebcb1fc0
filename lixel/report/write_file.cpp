// SPDX-License-Identifier: MIT
#include "lixel/report/write_file.h"

#include "lixel/base/assert.h"

#include <atomic>
#include <cerrno>
#include <climits>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lixel {
namespace {

bool isStaged(const fs::path& path)
{
    return path.native().find("/" + std::string(kStagedPrefix)) != std::string::npos;
}

std::string reasonOf(int errorNumber) { return std::generic_category().message(errorNumber); }

} // namespace

OutputError::OutputError(const fs::path& path, const std::string& reason)
    : std::runtime_error(path.string() + ": cannot be written: " + reason)
{
}

OutputError::OutputError(const fs::path& path, int errorNumber) : OutputError(path, reasonOf(errorNumber)) {}

OutputPlace placeOf(const fs::path& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) throw OutputError(path, EISDIR);
    if (path.filename().empty()) throw OutputError(path, ENOENT);
    if (fs::exists(status) && !fs::is_regular_file(status)) return {path, true};
    // One that leads to a file that is not there yet is followed, too; a circle of them has no status.
    if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
        throw OutputError(path, error.value());
    fs::path target = path;
    while (fs::is_symlink(fs::symlink_status(target, error))) target = target.parent_path() / fs::read_symlink(target);
    return {target};
}

fs::path temporaryName(const fs::path& target, std::string_view ending)
{
    static std::atomic<unsigned> count{0};
    const std::string suffix =
        "." + std::to_string(getpid()) + "-" + std::to_string(count++) + "." + std::string(ending);
    // Room for the suffix in file systems that end names at 255 bytes.
    return target.parent_path() / ("." + target.filename().string().substr(0, 200) + suffix);
}

AtomicFile::AtomicFile(const fs::path& path) : path_(path), place_(placeOf(path))
{
    if (place_.isInPlace) {
        descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) fail(errno);
        return;
    }

    // The name is known to the signal handler before the file is there, so that none can slip through. A file left by
    // an earlier process of this number only costs another try.
    do {
        pending_.release();
        temporary_ = temporaryName(place_.target);
        if (temporary_.native().size() >= PATH_MAX) fail(ENAMETOOLONG);
        if (!pending_.hold(temporary_.native())) fail(EMFILE);
        descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) {
        pending_.release();
        fail(errno);
    }
}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::write(std::string_view bytes)
{
    LX_ASSERT(descriptor_ >= 0);
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(errno);
        bytes.remove_prefix(std::size_t(written));
    }
}

void AtomicFile::commit()
{
    LX_ASSERT(descriptor_ >= 0);
    const int closed = close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail(errno);
    if (!pending_) return;
    if (isStaged(place_.target)) removeWhenInterrupted(place_.target);
    if (std::rename(temporary_.c_str(), place_.target.c_str()) != 0) fail(errno);
    pending_.release();
}

void AtomicFile::discard() noexcept
{
    if (descriptor_ >= 0) close(descriptor_);
    descriptor_ = -1;
    if (!pending_) return;
    unlink(temporary_.c_str());
    pending_.release();
}

void AtomicFile::fail(int errorNumber)
{
    discard();
    if (place_.target == path_) throw OutputError(path_, errorNumber);
    throw OutputError(path_, "the link leads to " + place_.target.string() + ": " + reasonOf(errorNumber));
}

void writeFileAtomically(const fs::path& path, std::string_view bytes)
{
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

void makeFolder(const fs::path& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    if (error) throw OutputError(path, error.value());
    if (!fs::is_directory(path)) throw OutputError(path, ENOTDIR);
}

} // namespace lixel
