// SPDX-License-Identifier: MIT
#include "lixel/report/interruption.h"

#include "lixel/base/assert.h"

#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>
#include <unistd.h>

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

// What goes with an interrupted process, the newest first, for the signal handler too: a name that is linked stays as it is until the
// process ends.
struct InterruptedName
{
    std::string path;
    InterruptedName* older;
};
std::atomic<InterruptedName*> interruptedNames{nullptr};
static_assert(std::atomic<InterruptedName*>::is_always_lock_free);

enum Phase { Ordinary, Quiet, Ending };
std::atomic<int> phase{Ordinary};
std::atomic<int> waitingSignal{0};

} // namespace

bool removePendingFiles(int signal) noexcept
{
    // In this order, so that either this call finds the quiet over, or its end finds the signal.
    waitingSignal.store(signal);
    int expected = Ordinary;
    if (!phase.compare_exchange_strong(expected, Ending) && expected == Quiet) return false;
    for (PendingFile& pending : pendingFiles)
        if (pending.state.load() == PendingFile::Named) unlink(pending.path);
    // Files come after their folders, that is, before them in the list.
    for (const InterruptedName* name = interruptedNames.load(); name; name = name->older)
        if (unlink(name->path.c_str()) != 0) rmdir(name->path.c_str());
    return true;
}

void removeWhenInterrupted(const std::filesystem::path& path)
{
    auto* const name = new InterruptedName{path.native(), interruptedNames.load()};
    while (!interruptedNames.compare_exchange_weak(name->older, name)) {
    }
}

Undisturbed::Undisturbed() noexcept
{
    int expected = Ordinary;
    while (!phase.compare_exchange_strong(expected, Quiet)) { // a handler in another thread ends the process
        LX_ASSERT(expected == Ending);
        pause();
        expected = Ordinary;
    }
}

Undisturbed::~Undisturbed()
{
    phase.store(Ordinary);
    if (const int signal = waitingSignal.exchange(0)) std::raise(signal);
}

bool PendingName::hold(const std::string& path)
{
    LX_ASSERT(slot_ < 0 && path.size() < PATH_MAX);
    for (int slot = 0; slot < kMaxPending; ++slot) {
        PendingFile& pending = pendingFiles[slot];
        int expected = PendingFile::Free;
        if (!pending.state.compare_exchange_strong(expected, PendingFile::Reserved)) continue;
        std::memcpy(pending.path, path.c_str(), path.size() + 1);
        pending.state.store(PendingFile::Named);
        slot_ = slot;
        return true;
    }
    return false;
}

void PendingName::release() noexcept
{
    if (slot_ >= 0) pendingFiles[slot_].state.store(PendingFile::Free);
    slot_ = -1;
}

} // namespace lixel
