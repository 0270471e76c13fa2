// What killed writers leave is told from what is being written, and from other files.
#include "io/output_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "io/sink.h"
#include "scratch_folder.h"

namespace obby::io {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::ScratchFolder;

// By a process that ends in the midst of it and clears nothing up.
bool leaveHalf(const std::string& path) {
  const pid_t writer = fork();
  if (writer == 0) {
    auto sink = Sink::open(path);
    _exit(sink && sink->write("half") && sink->flush() ? 0 : 1);
  }
  int status = 1;
  return waitpid(writer, &status, 0) == writer && status == 0;
}

TEST(OutputFile, WhatAKilledWriterLeftIsRemoved) {
  ScratchFolder folder;
  const std::string path = folder / "out";
  std::ofstream(path) << "old";
  ASSERT_TRUE(leaveHalf(path));
  ASSERT_EQ(folder.entries(), 2u);
  removeLeftovers(path);
  EXPECT_EQ(folder.entries(), 1u);
  EXPECT_EQ(contents(path), "old");
}

TEST(OutputFile, WhoWritesAFileRemovesWhatKilledOnesLeftOfIt) {
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

TEST(OutputFile, VeryLongNamesLeaveRoomForTheMark) {
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

TEST(OutputFile, LeftoversLieWhereTheLinkLeads) {
  ScratchFolder folder;
  fs::create_directory(folder / "runs");
  fs::create_symlink("runs/newest", folder / "link");
  ASSERT_TRUE(leaveHalf(folder / "link"));
  ASSERT_FALSE(fs::is_empty(folder / "runs"));
  removeLeftovers(folder / "link");
  EXPECT_TRUE(fs::is_empty(folder / "runs"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
}

TEST(OutputFile, WhatIsBeingWrittenStays) {
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
  removeLeftovers(folder / "no/where");  // nothing to look at
}

}  // namespace
}  // namespace obby::io
