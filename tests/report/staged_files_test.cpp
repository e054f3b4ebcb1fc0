// SPDX-License-Identifier: MIT
#include "lixel/report/staged_files.h"

#include "sample_results.h"

#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace lixel::test {
namespace {

TEST(StagedFiles, TakeTheirPlacesTogether)
{
    const TemporaryFolder folder;
    const fs::path one = folder.path() / "one", other = folder.path() / "other", link = folder.path() / "link";
    writeFileAtomically(one, "old");
    writeFileAtomically(folder.path() / "linked", "old");
    fs::create_symlink("linked", link);
    {
        StagedFiles files;
        for (const fs::path& path : {one, other, link}) writeFileAtomically(files.add(path), "new");
        EXPECT_EQ(readWhole(one), "old");
        EXPECT_FALSE(fs::exists(other));
        files.commit();
    }
    EXPECT_EQ(readWhole(one), "new");
    EXPECT_EQ(readWhole(other), "new");
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(readWhole(folder.path() / "linked"), "new");
    EXPECT_EQ(folder.fileCount(), 4u);
    EXPECT_EQ(StagedFiles().add("/dev/null"), "/dev/null");
}

TEST(StagedFiles, LeaveNothingWithoutCommit)
{
    const TemporaryFolder folder;
    writeFileAtomically(folder.path() / "one", "old");
    {
        StagedFiles files;
        writeFileAtomically(files.add(folder.path() / "one"), "new");
        writeFileAtomically(files.add(folder.path() / "other"), "new");
    }
    EXPECT_EQ(readWhole(folder.path() / "one"), "old");
    EXPECT_EQ(folder.fileCount(), 1u);
}

// Whichever of them it is that cannot: all stay as they were.
TEST(StagedFiles, WhereOneCannotTakeItsPlaceAllStayAsTheyWere)
{
    const char* const names[] = {"one", "two", "three", "four"}; // two of them are there already
    for (const char* failing : names) {
        const TemporaryFolder folder;
        writeFileAtomically(folder.path() / "one", "old");
        writeFileAtomically(folder.path() / "three", "old");
        {
            StagedFiles files;
            for (const char* name : names) {
                const fs::path written = files.add(folder.path() / name);
                if (name != failing) writeFileAtomically(written, "new");
            }
            EXPECT_THROW(files.commit(), OutputError) << failing;
        }
        EXPECT_EQ(readWhole(folder.path() / "one"), "old") << failing;
        EXPECT_EQ(readWhole(folder.path() / "three"), "old") << failing;
        EXPECT_EQ(folder.fileCount(), 2u) << failing;
    }
}

TEST(StagedFolder, KeepsWhatIsThereUntilAllTakeTheirPlaces)
{
    const TemporaryFolder folder;
    const fs::path pictures = folder.path() / "pictures";
    makeFolder(pictures);
    writeFileAtomically(folder.path() / "results", "old");
    writeFileAtomically(pictures / "one", "old");
    writeFileAtomically(pictures / "other", "somebody's");
    {
        StagedFolder staged(folder.path());
        staged.makeFolder("pictures");
        writeFileAtomically(staged.path() / "results", "new");
        writeFileAtomically(staged.path() / "pictures" / "one", "new");
        EXPECT_EQ(readWhole(folder.path() / "results"), "old");
        EXPECT_EQ(readWhole(pictures / "one"), "old");
        staged.commit();
    }
    EXPECT_EQ(readWhole(folder.path() / "results"), "new");
    EXPECT_EQ(readWhole(pictures / "one"), "new");
    EXPECT_EQ(readWhole(pictures / "other"), "somebody's");
    EXPECT_EQ(folder.fileCount(), 2u);
}

TEST(StagedFolder, LeavesNothingWithoutCommit)
{
    const TemporaryFolder folder;
    {
        StagedFolder staged(folder.path());
        staged.makeFolder("pictures");
        writeFileAtomically(staged.path() / "pictures" / "one", "new");
    }
    EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(StagedFolder, FollowsLinksAndWritesIntoDevicesInPlace)
{
    const TemporaryFolder folder;
    writeFileAtomically(folder.path() / "real", "old");
    fs::create_symlink("real", folder.path() / "link");
    fs::create_symlink("/dev/null", folder.path() / "nothing");
    StagedFolder staged(folder.path());
    for (const char* name : {"link", "nothing"}) writeFileAtomically(staged.path() / name, "new");
    staged.commit();
    EXPECT_EQ(readWhole(folder.path() / "real"), "new");
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
    EXPECT_TRUE(fs::is_character_file(folder.path() / "nothing"));
}

TEST(StagedFolder, WhereOneCannotTakeItsPlaceAllStayAsTheyWere)
{
    const TemporaryFolder folder;
    const fs::path pictures = folder.path() / "pictures";
    makeFolder(pictures / "b"); // where a file is to go
    writeFileAtomically(folder.path() / "results", "old");
    writeFileAtomically(pictures / "a", "old");
    {
        StagedFolder staged(folder.path());
        staged.makeFolder("pictures");
        staged.makeFolder("more");
        writeFileAtomically(staged.path() / "results", "new");
        writeFileAtomically(staged.path() / "more" / "a", "new");
        for (const char* name : {"a", "b", "c"}) writeFileAtomically(staged.path() / "pictures" / name, "new");
        EXPECT_THROW(staged.commit(), OutputError);
    }
    EXPECT_EQ(readWhole(folder.path() / "results"), "old");
    EXPECT_EQ(readWhole(pictures / "a"), "old");
    EXPECT_FALSE(fs::exists(folder.path() / "more"));
    EXPECT_EQ(folder.fileCount(), 2u);
}

} // namespace
} // namespace lixel::test
