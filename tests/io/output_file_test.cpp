// Leftovers of killed writers are told apart from files being written and from other files. Of two
// processes that want one file, only one gets it.
#include "io/output_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "io/sink.h"
#include "io/text.h"
#include "scratch_folder.h"

namespace obby::io {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::ScratchFolder;

// Leaves half a file behind, by a process that exits without cleaning up.
bool leaveHalf(const std::string& path) {
  const pid_t writer = fork();
  if (writer == 0) {
    auto sink = Sink::open(path);
    _exit(sink && sink->write("half") && sink->flush() ? 0 : 1);
  }
  int status = 1;
  return waitpid(writer, &status, 0) == writer && status == 0;
}

TEST(OutputFile, LeftoversOfAKilledWriterAreRemoved) {
  ScratchFolder folder;
  const std::string path = folder / "out";
  std::ofstream(path) << "old";
  ASSERT_TRUE(leaveHalf(path));
  ASSERT_EQ(folder.entries(), 2u);
  removeLeftovers(path);
  EXPECT_EQ(folder.entries(), 1u);
  EXPECT_EQ(contents(path), "old");
}

TEST(OutputFile, AWriterRemovesLeftoversOfKilledWriters) {
  ScratchFolder folder;
  ASSERT_TRUE(leaveHalf(folder / "out"));
  ASSERT_TRUE(leaveHalf(folder / "other"));
  auto first = Sink::open(folder / "out");
  ASSERT_TRUE(first);
  EXPECT_EQ(folder.entries(), 2u) << "its own, and that of the other";
  auto second = Sink::open(folder / "out");
  ASSERT_TRUE(second);
  EXPECT_EQ(folder.entries(), 3u) << "what is being written stays";
  ASSERT_TRUE(first->write("first") && first->close());
  ASSERT_TRUE(second->write("second") && second->close());
  EXPECT_EQ(contents(folder / "out"), "second");
  EXPECT_EQ(folder.entries(), 2u);
}

TEST(OutputFile, VeryLongNamesAreCutToFitTheSuffix) {
  ScratchFolder folder;
  const std::string path = folder / std::string(255, 'a');
  ASSERT_TRUE(leaveHalf(path));
  EXPECT_EQ(folder.entries(), 1u);
  removeLeftovers(path);
  EXPECT_EQ(folder.entries(), 0u);
  auto sink = Sink::open(path);
  ASSERT_TRUE(sink && sink->write("whole") && sink->close());
  EXPECT_EQ(contents(path), "whole");
}

TEST(OutputFile, LongNamesWithACommonPrefixKeepTheirOwnLeftovers) {
  ScratchFolder folder;
  const std::string path = folder / std::string(240, 'a');
  ASSERT_TRUE(leaveHalf(path));
  removeLeftovers(path + "b");
  EXPECT_EQ(folder.entries(), 1u);
  removeLeftovers(path);
  EXPECT_EQ(folder.entries(), 0u);
}

// Some systems require file names in UTF-8.
TEST(OutputFile, VeryLongNamesAreCutBetweenCharacters) {
  ScratchFolder folder;
  for (const char* begin : {"", "x"}) {
    std::string name = begin;
    while (name.size() < 250) name += "\u00e4";
    ASSERT_TRUE(leaveHalf(folder / name));
    for (const auto& entry : fs::directory_iterator(folder / "."))
      EXPECT_TRUE(isUtf8(entry.path().filename().string())) << entry.path();
    removeLeftovers(folder / name);
    EXPECT_EQ(folder.entries(), 0u);
  }
}

TEST(OutputFile, LeftoversAreInTheFolderOfTheLinksTarget) {
  ScratchFolder folder;
  fs::create_directory(folder / "runs");
  fs::create_symlink("runs/newest", folder / "link");
  ASSERT_TRUE(leaveHalf(folder / "link"));
  ASSERT_FALSE(fs::is_empty(folder / "runs"));
  removeLeftovers(folder / "link");
  EXPECT_TRUE(fs::is_empty(folder / "runs"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
}

TEST(OutputFile, FilesBeingWrittenStay) {
  ScratchFolder folder;
  auto sink = Sink::open(folder / "out");
  ASSERT_TRUE(sink);
  ASSERT_TRUE(sink->write("whole"));
  removeLeftovers(folder / "out");
  ASSERT_TRUE(sink->close());
  EXPECT_EQ(contents(folder / "out"), "whole");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(OutputFile, OtherFilesStay) {
  ScratchFolder folder;
  const char* names[] = {"out",
                         "out.backup",
                         "out.obby-backup",
                         "out.obby-unfinished-",
                         "out.obby-unfinished-1234",
                         "out.obby-unfinished-long-one",
                         "other.obby-unfinished-aB3dE6"};
  for (const char* name : names) std::ofstream(folder / name) << "mine";
  fs::create_directory(folder / "out.obby-unfinished-folder");
  fs::create_symlink("out", folder / "out.obby-unfinished-alink0");
  removeLeftovers(folder / "out");
  EXPECT_EQ(folder.entries(), 9u);
  removeLeftovers(folder / "no/where");  // there is no folder to search
}

TEST(OutputLocks, AFileHasOneLockUnderAllItsPaths) {
  ScratchFolder folder;
  fs::create_directory(folder / "runs");
  fs::create_directory_symlink("runs", folder / "newest");
  fs::create_symlink("runs/out", folder / "link");
  OutputLocks second;
  {
    OutputLocks first;
    ASSERT_TRUE(first.take(folder / "runs/out"));
    EXPECT_TRUE(first.take(folder / "link")) << "its own";
    for (const char* name : {"runs/out", "runs/../runs/out", "newest/out", "link"})
      EXPECT_FALSE(second.take(folder / name)) << name;
    EXPECT_TRUE(second.take(folder / "runs/other"));
  }
  EXPECT_TRUE(second.take(folder / "link"));
}

TEST(OutputLocks, SurvivesARewriteOfTheFileAndLeavesNothing) {
  ScratchFolder folder;
  {
    OutputLocks first, second;
    ASSERT_TRUE(first.take(folder / "out"));
    for (const char* text : {"once", "again"}) {
      auto sink = Sink::open(folder / "out");
      ASSERT_TRUE(sink && sink->write(text) && sink->close());
      EXPECT_FALSE(second.take(folder / "out")) << text;
    }
  }
  EXPECT_EQ(contents(folder / "out"), "again");
  EXPECT_EQ(folder.entries(), 1u);
}

// Leaves a lock behind, by a process that exits without cleaning up.
bool leaveLocked(const std::string& path) {
  const pid_t writer = fork();
  if (writer == 0) {
    OutputLocks locks;
    _exit(locks.take(path) ? 0 : 1);
  }
  int status = 1;
  return waitpid(writer, &status, 0) == writer && status == 0;
}

TEST(OutputLocks, AKilledProcessLeavesNoLockButALeftover) {
  ScratchFolder folder;
  ASSERT_TRUE(leaveLocked(folder / "out"));
  ASSERT_EQ(folder.entries(), 1u);
  {
    OutputLocks next;
    EXPECT_TRUE(next.take(folder / "out"));
    removeLeftovers(folder / "out");
    EXPECT_EQ(folder.entries(), 1u) << "held again";
  }
  EXPECT_EQ(folder.entries(), 0u);
  ASSERT_TRUE(leaveLocked(folder / "out"));
  removeLeftovers(folder / "out");
  EXPECT_EQ(folder.entries(), 0u);
}

// If the lock file is removed by hand, another process may take the lock. Its lock file must stay.
TEST(OutputLocks, KeepsTheLockFileOfAnotherProcess) {
  ScratchFolder folder;
  OutputLocks second, third;
  {
    OutputLocks first;
    ASSERT_TRUE(first.take(folder / "out"));
    ASSERT_TRUE(fs::remove(folder / "out.obby-unfinished-locked"));
    ASSERT_TRUE(second.take(folder / "out"));
  }
  EXPECT_FALSE(third.take(folder / "out"));
}

// Long names are cut to fit the lock's suffix, and these two share the part that is left.
TEST(OutputLocks, LongNamesWithACommonPrefixHaveSeparateLocks) {
  ScratchFolder folder;
  const std::string path = folder / std::string(240, 'a'), other = path + "b";
  OutputLocks first, second;
  EXPECT_TRUE(first.take(path));
  EXPECT_TRUE(first.take(path)) << "its own";
  EXPECT_FALSE(second.take(path));
  EXPECT_TRUE(second.take(other));
  EXPECT_FALSE(first.take(other));
  EXPECT_EQ(folder.entries(), 2u);
}

TEST(OutputLocks, AllowsEveryWriterWhereLockingIsImpossible) {
  ScratchFolder folder;
  OutputLocks first, second;
  EXPECT_TRUE(first.take(folder / "no/where"));
  EXPECT_TRUE(second.take(folder / "no/where"));
  EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace obby::io
