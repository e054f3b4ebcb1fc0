// SPDX-License-Identifier: MIT
#include "lixel/report/write_file.h"

#include "lixel/base/assert.h"

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;

namespace lixel {
namespace {

// The temporary files of this process, in memory that a signal handler may read: it can neither lock nor allocate.
struct PendingFile
{
    enum State { Free, Reserved, Named };
    std::atomic<int> state{Free};
    char path[PATH_MAX] = {};
};
constexpr int kMaxPending = 32; // files open for writing at once
PendingFile pendingFiles[kMaxPending];
static_assert(std::atomic<int>::is_always_lock_free);

// A slot that names `path`, or -1 when all are taken.
int reserveSlot(const std::string& path)
{
    for (int slot = 0; slot < kMaxPending; ++slot) {
        PendingFile& pending = pendingFiles[slot];
        int expected = PendingFile::Free;
        if (!pending.state.compare_exchange_strong(expected, PendingFile::Reserved)) continue;
        std::memcpy(pending.path, path.c_str(), path.size() + 1);
        pending.state.store(PendingFile::Named);
        return slot;
    }
    return -1;
}

// What goes with an interrupted process, the newest first, for the signal handler too: a name that is linked stays as it is until the
// process ends.
struct InterruptedName
{
    std::string path;
    InterruptedName* older;
};
std::atomic<InterruptedName*> interruptedNames{nullptr};
static_assert(std::atomic<InterruptedName*>::is_always_lock_free);

constexpr std::string_view kStagedPrefix = ".lixel-staged-";

bool isStaged(const fs::path& path)
{
    return path.native().find("/" + std::string(kStagedPrefix)) != std::string::npos;
}

std::string reasonOf(int errorNumber) { return std::generic_category().message(errorNumber); }

fs::path temporaryName(const fs::path& target)
{
    static std::atomic<unsigned> count{0};
    const std::string suffix = "." + std::to_string(getpid()) + "-" + std::to_string(count++) + ".part";
    // Room for the suffix in file systems that end names at 255 bytes.
    return target.parent_path() / ("." + target.filename().string().substr(0, 200) + suffix);
}

} // namespace

OutputError::OutputError(const fs::path& path, const std::string& reason)
    : std::runtime_error(path.string() + ": cannot be written: " + reason)
{
}

AtomicFile::AtomicFile(const fs::path& path) : path_(path), target_(path)
{
    // What is there already decides how to write: a file is replaced, through its links; a device is written to.
    std::error_code error;
    const fs::file_status status = fs::status(path_, error);
    if (fs::is_directory(status)) fail(EISDIR);
    if (path_.filename().empty()) fail(ENOENT);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) fail(errno);
        return;
    }
    if (fs::is_symlink(fs::symlink_status(path_, error))) {
        target_ = fs::weakly_canonical(path_, error);
        if (error) fail(error.value());
    }

    // The name is known to the signal handler before the file is there, so that none can slip through. A file left by
    // an earlier process of this number only costs another try.
    do {
        temporary_ = temporaryName(target_);
        if (temporary_.native().size() >= PATH_MAX) fail(ENAMETOOLONG);
        slot_ = reserveSlot(temporary_.native());
        if (slot_ < 0) fail(EMFILE);
        descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0) pendingFiles[slot_].state.store(PendingFile::Free);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) {
        slot_ = -1;
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
    if (slot_ < 0) return;
    if (isStaged(target_)) removeWhenInterrupted(target_);
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    pendingFiles[slot_].state.store(PendingFile::Free);
    slot_ = -1;
}

void AtomicFile::discard() noexcept
{
    if (descriptor_ >= 0) close(descriptor_);
    descriptor_ = -1;
    if (slot_ < 0) return;
    unlink(temporary_.c_str());
    pendingFiles[slot_].state.store(PendingFile::Free);
    slot_ = -1;
}

void AtomicFile::fail(int errorNumber)
{
    discard();
    throw OutputError(path_, reasonOf(errorNumber));
}

void writeFileAtomically(const fs::path& path, std::string_view bytes)
{
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

void removeWhenInterrupted(const fs::path& path)
{
    auto* const name = new InterruptedName{path.native(), interruptedNames.load()};
    while (!interruptedNames.compare_exchange_weak(name->older, name)) {
    }
}

void makeFolder(const fs::path& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    if (error) throw OutputError(path, reasonOf(error.value()));
    if (!fs::is_directory(path)) throw OutputError(path, reasonOf(ENOTDIR));
}

StagedFolder::StagedFolder(const fs::path& folder) : folder_(fs::absolute(folder))
{
    static std::atomic<unsigned> count{0};
    path_ = folder_ / (std::string(kStagedPrefix) + std::to_string(getpid()) + "-" + std::to_string(count++));
    makeFolder("");
}

StagedFolder::~StagedFolder()
{
    std::error_code stays;
    fs::remove_all(path_, stays);
}

void StagedFolder::makeFolder(const std::string& name)
{
    const fs::path made = name.empty() ? path_ : path_ / name;
    removeWhenInterrupted(made);
    lixel::makeFolder(made);
}

void StagedFolder::commit()
{
    struct Move
    {
        fs::path from, to;
        bool isInPlace; // a device is written to
    };
    std::vector<Move> ofFolder, below;
    for (const auto& entry : fs::recursive_directory_iterator(path_)) {
        fs::path place = folder_ / entry.path().lexically_relative(path_);
        std::error_code error;
        if (fs::is_symlink(fs::symlink_status(place, error))) place = fs::weakly_canonical(place, error);
        if (error && error != std::errc::no_such_file_or_directory) throw OutputError(place, error.message());
        if (entry.is_directory()) {
            lixel::makeFolder(place);
            continue;
        }
        const bool isDevice = fs::exists(place, error) && !fs::is_regular_file(place, error);
        (entry.path().parent_path() == path_ ? ofFolder : below).push_back({entry.path(), place, isDevice});
    }
    for (const Move& move : ofFolder)
        if (!move.isInPlace && unlink(move.to.c_str()) != 0 && errno != ENOENT)
            throw OutputError(move.to, reasonOf(errno));
    for (const auto* const moves : {&below, &ofFolder})
        for (const auto& [from, to, isInPlace] : *moves) {
            if (!isInPlace && std::rename(from.c_str(), to.c_str()) == 0) continue;
            std::ifstream file(from, std::ios::binary); // to a link into another file system, too
            writeFileAtomically(to, std::string(std::istreambuf_iterator<char>(file), {}));
        }
}

void removePendingFiles() noexcept
{
    for (PendingFile& pending : pendingFiles)
        if (pending.state.load() == PendingFile::Named) unlink(pending.path);
    // Files come after their folders, that is, before them in the list.
    for (const InterruptedName* name = interruptedNames.load(); name; name = name->older)
        if (unlink(name->path.c_str()) != 0) rmdir(name->path.c_str());
}

} // namespace lixel
