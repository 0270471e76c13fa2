// Temporary names are short enough for their folder. If two processes try to write one file, only
// one succeeds.
#include "io/output_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "io/sink.h"
#include "io/utf8.h"
#include "scratch_folder.h"

namespace obby::io {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::ScratchFolder;

// Returns the name of the only file in the folder.
std::string onlyName(const ScratchFolder& folder) {
  EXPECT_EQ(folder.entries(), 1u);
  return fs::directory_iterator(folder / ".")->path().filename().string();
}

TEST(OutputFile, TwoWritersOfAFileDoNotMixTheirBytes) {
  ScratchFolder folder;
  auto first = Sink::open(folder / "out"), second = Sink::open(folder / "out");
  ASSERT_TRUE(first && second);
  EXPECT_EQ(folder.entries(), 2u);
  ASSERT_TRUE(first->write("first") && second->write("second"));
  ASSERT_TRUE(first->close() && second->close());
  EXPECT_EQ(contents(folder / "out"), "second");
  EXPECT_EQ(folder.entries(), 1u);
}

// Some systems require file names in UTF-8.
TEST(OutputFile, VeryLongNamesAreCutBetweenCharacters) {
  for (const char* begin : {"", "x"}) {
    ScratchFolder folder;
    std::string name = begin;
    while (name.size() < 254) name += "\u00e4";
    auto sink = Sink::open(folder / name);
    ASSERT_TRUE(sink && sink->write("whole"));
    EXPECT_TRUE(isUtf8(onlyName(folder))) << onlyName(folder);
    ASSERT_TRUE(sink->close());
    EXPECT_EQ(onlyName(folder), name);
    EXPECT_EQ(contents(folder / name), "whole");
  }
}

TEST(OutputFile, TheTemporaryFileIsInTheFolderOfTheLinksTarget) {
  ScratchFolder folder;
  fs::create_directory(folder / "runs");
  fs::create_symlink("runs/newest", folder / "link");
  auto sink = Sink::open(folder / "link");
  ASSERT_TRUE(sink);
  EXPECT_FALSE(fs::is_empty(folder / "runs"));
}

TEST(OutputLocks, LongNamesWithACommonPrefixHaveSeparateLocks) {
  ScratchFolder folder;
  const std::string path = folder / std::string(240, 'a'), other = path + "b";
  OutputLocks first, second;
  EXPECT_TRUE(first.take(path));
  EXPECT_FALSE(second.take(path));
  EXPECT_TRUE(second.take(other));
  EXPECT_FALSE(first.take(other));
  EXPECT_EQ(folder.entries(), 2u);
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

// Takes a lock in a process that exits without cleanup, so the lock file stays. Returns true on
// success.
bool leaveLocked(const std::string& path) {
  const pid_t writer = fork();
  if (writer == 0) {
    OutputLocks locks;
    _exit(locks.take(path) ? 0 : 1);
  }
  int status = 1;
  return waitpid(writer, &status, 0) == writer && status == 0;
}

TEST(OutputLocks, AKilledProcessLeavesNoLock) {
  ScratchFolder folder;
  ASSERT_TRUE(leaveLocked(folder / "out"));
  ASSERT_EQ(folder.entries(), 1u);
  {
    OutputLocks next, other;
    EXPECT_TRUE(next.take(folder / "out"));
    EXPECT_FALSE(other.take(folder / "out"));
  }
  EXPECT_EQ(folder.entries(), 0u);
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
