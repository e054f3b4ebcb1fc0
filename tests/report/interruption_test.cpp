// SPDX-License-Identifier: MIT
#include "lixel/report/interruption.h"

#include "lixel/report/staged_files.h"
#include "sample_results.h"

#include <csignal>
#include <functional>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lixel::test {
namespace {

constexpr int kInterrupted = 130;

// What a process of its own ends with when it does this, with a handler as the command line has it: one that tidies up and ends.
int codeOf(const std::function<void()>& work)
{
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGINT, [](int signal) {
            if (removePendingFiles(signal)) _exit(kInterrupted);
        });
        work();
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Interruption, LeavesNothingThatIsHalf)
{
    const TemporaryFolder folder;
    const int code = codeOf([&] {
        AtomicFile one(folder.path() / "one.txt"), other(folder.path() / "other.txt");
        StagedFolder staged(folder.path());
        staged.makeFolder("pictures");
        writeFileAtomically(staged.path() / "pictures" / "whole", "whole");
        StagedFiles files;
        writeFileAtomically(files.add(folder.path() / "one of two"), "whole");
        one.write("half");
        other.write("half");
        std::raise(SIGINT);
    });
    EXPECT_EQ(code, kInterrupted);
    EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(Interruption, LeavesWhatIsWhole)
{
    const TemporaryFolder folder;
    const int code = codeOf([&] {
        writeFileAtomically(folder.path() / "a.txt", "whole");
        std::raise(SIGINT);
    });
    EXPECT_EQ(code, kInterrupted);
    EXPECT_EQ(readWhole(folder.path() / "a.txt"), "whole");
}

TEST(Interruption, WaitsWhileFilesTakeTheirPlaces)
{
    const TemporaryFolder folder;
    const int code = codeOf([&] {
        {
            const Undisturbed quiet;
            std::raise(SIGINT);
            writeFileAtomically(folder.path() / "during.txt", "whole");
        }
        writeFileAtomically(folder.path() / "after.txt", "whole");
    });
    EXPECT_EQ(code, kInterrupted);
    EXPECT_TRUE(fs::exists(folder.path() / "during.txt"));
    EXPECT_FALSE(fs::exists(folder.path() / "after.txt"));
}

} // namespace
} // namespace lixel::test
