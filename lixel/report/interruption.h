// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

// What is half-written when a signal ends the process: the handler removes it, and lets files that are just taking their places do so.
namespace lixel {

// To be called by the handler of signals that end the process, which is safe. Removes the temporary files of every AtomicFile that is
// still open, in all threads, those that are staged, and what is named to removeWhenInterrupted(); the process must end then. False
// while an Undisturbed lives: nothing was removed, the process must go on, and the signal is raised again afterwards.
bool removePendingFiles(int signal) noexcept;

// To be called before the file or folder is there: removePendingFiles() removes it too, a folder only when it is empty.
void removeWhenInterrupted(const std::filesystem::path& path);

// Whole files below a folder whose name begins so are half of something, too.
inline constexpr std::string_view kStagedPrefix = ".lixel-staged-";

// While it lives, signals wait: for what is whole only when all of it is done. One at a time, and short.
class Undisturbed
{
public:
    Undisturbed() noexcept; // does not return when the process is about to end
    Undisturbed(const Undisturbed&) = delete;
    Undisturbed& operator=(const Undisturbed&) = delete;
    ~Undisturbed();
};

// The name of a temporary file, for as long as it is one.
class PendingName
{
public:
    PendingName() = default;
    PendingName(const PendingName&) = delete;
    PendingName& operator=(const PendingName&) = delete;
    ~PendingName() { release(); }

    bool hold(const std::string& path); // false when the process has as many as there is room for; path below PATH_MAX
    void release() noexcept;
    explicit operator bool() const { return slot_ >= 0; }

private:
    int slot_ = -1;
};

} // namespace lixel
