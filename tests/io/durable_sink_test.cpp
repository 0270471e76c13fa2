// A durable file is on the disk before it is renamed, and its new name is on the disk before
// close() returns. This file replaces fsync() by a function that records the state of the files and
// fails on request.
#include <errno.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "io/sink.h"
#include "scratch_folder.h"

namespace {

struct Sync {
  bool folder;
  std::string named;  // the content of `watched` at the time of the call
};

std::vector<Sync> syncs;
std::string watched;
int failingSync = -1;  // index of the call that fails; -1 if none fails
int failure = EIO;     // its errno

}  // namespace

extern "C" int fsync(int fd) {
  struct stat info {};
  fstat(fd, &info);
  syncs.push_back({S_ISDIR(info.st_mode), obby::test::contents(watched)});
  if (int(syncs.size()) - 1 == failingSync) {
    errno = failure;
    return -1;
  }
  return int(syscall(SYS_fsync, fd));
}

namespace obby::io {
namespace {

using test::contents;
using test::ScratchFolder;

// Writes "new" over "old".
Status write(const std::string& path, Durable durable, int failing = -1, int error = EIO) {
  std::ofstream(path) << "old";
  syncs.clear();
  watched = path;
  failingSync = failing;
  failure = error;
  auto sink = Sink::open(path, durable);
  EXPECT_TRUE(sink);
  EXPECT_TRUE(sink->write("new"));
  EXPECT_TRUE(syncs.empty());
  return sink->close();
}

TEST(DurableSink, TheFileIsSyncedBeforeTheRenameAndTheFolderAfterIt) {
  ScratchFolder folder;
  ASSERT_TRUE(write(folder / "out", Durable::yes));
  ASSERT_EQ(syncs.size(), 2u);
  EXPECT_FALSE(syncs[0].folder);
  EXPECT_EQ(syncs[0].named, "old");
  EXPECT_TRUE(syncs[1].folder);
  EXPECT_EQ(syncs[1].named, "new");
}

TEST(DurableSink, OtherSinksDoNotSync) {
  ScratchFolder folder;
  ASSERT_TRUE(write(folder / "out", Durable::no));
  EXPECT_TRUE(syncs.empty());
  EXPECT_EQ(contents(folder / "out"), "new");
  syncs.clear();
  auto nowhere = Sink::open("/dev/null", Durable::yes);
  ASSERT_TRUE(nowhere && nowhere->write("x") && nowhere->close());
  EXPECT_TRUE(syncs.empty()) << "a device";
}

TEST(DurableSink, AFailedSyncKeepsTheOldFile) {
  ScratchFolder folder;
  const Status file = write(folder / "out", Durable::yes, 0);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().message, "cannot write: Input/output error");
  EXPECT_EQ(contents(folder / "out"), "old");
  EXPECT_EQ(folder.entries(), 1u) << "nothing else is left";
  EXPECT_FALSE(write(folder / "out", Durable::yes, 1)) << "the name";
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(DurableSink, AFileSystemWithoutSyncIsNoError) {
  ScratchFolder folder;
  for (const int call : {0, 1}) {  // the calls for the file and for its folder
    const Status status = write(folder / "out", Durable::yes, call, EINVAL);
    EXPECT_TRUE(status) << status.error().text();
    EXPECT_EQ(syncs.size(), 2u);
    EXPECT_EQ(contents(folder / "out"), "new");
    EXPECT_FALSE(write(folder / "out", Durable::yes, call, EROFS)) << "a disk that has failed";
  }
}

TEST(DurableSink, ASignalDoesNotEndTheSync) {
  ScratchFolder folder;
  for (const int call : {0, 1}) {
    ASSERT_TRUE(write(folder / "out", Durable::yes, call, EINTR));
    EXPECT_EQ(syncs.size(), 3u) << "asked again";
  }
}

}  // namespace
}  // namespace obby::io
