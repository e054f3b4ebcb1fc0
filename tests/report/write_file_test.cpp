// SPDX-License-Identifier: MIT
#include "lixel/report/write_file.h"

#include "sample_results.h"

#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lixel::test {
namespace {

std::string messageOf(const std::function<void()>& write)
{
    try {
        write();
    } catch (const OutputError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(AtomicFile, IsWholeAndAloneOnceCommitted)
{
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a.txt";
    AtomicFile file(path);
    file.write("one ");
    file.write("two");
    EXPECT_FALSE(fs::exists(path));
    file.commit();
    EXPECT_EQ(readWhole(path), "one two");
    EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(AtomicFile, LeavesNothingWithoutCommit)
{
    const TemporaryFolder folder;
    {
        AtomicFile file(folder.path() / "a.txt");
        file.write("half");
        EXPECT_EQ(folder.fileCount(), 1u);
    }
    EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(AtomicFile, KeepsTheOldFileUntilTheNewOneIsWhole)
{
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a.txt";
    writeFileAtomically(path, "old");
    {
        AtomicFile file(path);
        file.write("ne");
        EXPECT_EQ(readWhole(path), "old");
    }
    EXPECT_EQ(readWhole(path), "old");
    writeFileAtomically(path, "new");
    EXPECT_EQ(readWhole(path), "new");
    EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(AtomicFile, TakesManyBytes)
{
    const TemporaryFolder folder;
    const std::string bytes(5'000'000, '\x7f');
    writeFileAtomically(folder.path() / "a.bin", bytes);
    EXPECT_EQ(readWhole(folder.path() / "a.bin"), bytes);
}

TEST(AtomicFile, FollowsALinkAndKeepsIt)
{
    const TemporaryFolder folder;
    writeFileAtomically(folder.path() / "real.txt", "old");
    fs::create_symlink("real.txt", folder.path() / "link.txt");
    writeFileAtomically(folder.path() / "link.txt", "new");
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link.txt"));
    EXPECT_EQ(readWhole(folder.path() / "real.txt"), "new");

    // Over another link to what is not there yet; a circle leads nowhere.
    fs::create_symlink("later.txt", folder.path() / "second.txt");
    fs::create_symlink("second.txt", folder.path() / "first.txt");
    writeFileAtomically(folder.path() / "first.txt", "new");
    EXPECT_TRUE(fs::is_symlink(folder.path() / "first.txt"));
    EXPECT_EQ(readWhole(folder.path() / "later.txt"), "new");
    fs::create_symlink("circle", folder.path() / "circle");
    const std::string message = messageOf([&] { writeFileAtomically(folder.path() / "circle", "x"); });
    EXPECT_NE(message.find("Too many levels of symbolic links"), std::string::npos) << message;
}

TEST(AtomicFile, ALinkThatLeadsNowhereIsNamedWithItsEnd)
{
    const TemporaryFolder folder;
    const fs::path link = folder.path() / "link", end = folder.path() / "missing" / "a.txt";
    fs::create_symlink("missing/a.txt", link);
    EXPECT_EQ(messageOf([&] { writeFileAtomically(link, "x"); }),
              link.string() + ": cannot be written: the link leads to " + end.string() + ": No such file or directory");
}

TEST(AtomicFile, WritesIntoDevicesInPlace)
{
    writeFileAtomically("/dev/null", "gone");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_NE(messageOf([] { writeFileAtomically("/dev/full", "no room"); }).find("No space left"), std::string::npos);
}

TEST(AtomicFile, SaysInOneLineWhyItCannotWrite)
{
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "file";
    writeFileAtomically(file, "");
    const auto reasonFor = [](const fs::path& path) {
        const std::string message = messageOf([&] { writeFileAtomically(path, "x"); });
        EXPECT_EQ(message.rfind(path.string() + ": cannot be written: ", 0), 0u) << message;
        return message.substr(message.rfind(": ") + 2);
    };
    EXPECT_EQ(reasonFor(folder.path() / "missing" / "a.txt"), "No such file or directory");
    EXPECT_EQ(reasonFor(file / "a.txt"), "Not a directory");
    EXPECT_EQ(reasonFor(folder.path()), "Is a directory");
    EXPECT_EQ(reasonFor(""), "No such file or directory");
    EXPECT_EQ(reasonFor(folder.path() / std::string(5000, 'a')), "File name too long");
    EXPECT_EQ(folder.fileCount(), 1u);
}

// Where the user is root, rights stop nobody.
TEST(AtomicFile, AFolderWithoutRightsIsNamed)
{
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    const TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_EQ(messageOf([&] { writeFileAtomically(folder.path() / "a.txt", "x"); }),
              (folder.path() / "a.txt").string() + ": cannot be written: Permission denied");
    fs::permissions(folder.path(), fs::perms::owner_all);
}

TEST(AtomicFile, MoreThanAnybodyNeedsAreRefusedByName)
{
    const TemporaryFolder folder;
    std::vector<std::unique_ptr<AtomicFile>> files;
    const std::string message = messageOf([&] {
        for (int i = 0; i < 1000; ++i) files.push_back(std::make_unique<AtomicFile>(folder.path() / std::to_string(i)));
    });
    EXPECT_NE(message.find("Too many open files"), std::string::npos) << message;
    files.clear();
    EXPECT_EQ(folder.fileCount(), 0u);
    writeFileAtomically(folder.path() / "a.txt", "x"); // and later ones find room again
}

TEST(MakeFolder, MakesAllOfThePathAndSaysWhyItCannot)
{
    const TemporaryFolder folder;
    makeFolder(folder.path() / "a" / "b");
    makeFolder(folder.path() / "a" / "b");
    EXPECT_TRUE(fs::is_directory(folder.path() / "a" / "b"));
    writeFileAtomically(folder.path() / "file", "");
    EXPECT_EQ(messageOf([&] { makeFolder(folder.path() / "file" / "b"); }),
              (folder.path() / "file" / "b").string() + ": cannot be written: Not a directory");
    EXPECT_EQ(messageOf([&] { makeFolder(folder.path() / "file"); }),
              (folder.path() / "file").string() + ": cannot be written: Not a directory");
}

} // namespace
} // namespace lixel::test
