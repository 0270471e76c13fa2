// Failed output is reported, and an output file is whole or absent.
#include "io/sink.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include "io/read_file.h"
#include "scratch_folder.h"

namespace obby::io {
namespace {

using test::contents;
using test::ScratchFolder;

TEST(Sink, AFileAppearsWhenItIsClosed) {
  ScratchFolder folder;
  auto sink = Sink::open(folder / "out");
  ASSERT_TRUE(sink);
  ASSERT_TRUE(sink->write("one\n"));
  ASSERT_TRUE(sink->flush());
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  ASSERT_TRUE(sink->close());
  EXPECT_EQ(contents(folder / "out"), "one\n");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(Sink, AnUnclosedSinkLeavesOnlyTheOldFile) {
  ScratchFolder folder;
  std::ofstream(folder / "out") << "old";
  {
    auto sink = Sink::open(folder / "out");
    ASSERT_TRUE(sink);
    ASSERT_TRUE(sink->write(std::string(1000000, 'x')));
  }
  EXPECT_EQ(contents(folder / "out"), "old");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(Sink, KeepsTheModeOfAFileAndTheLinkToIt) {
  ScratchFolder folder;
  std::ofstream(folder / "real") << "old";
  ASSERT_EQ(chmod((folder / "real").c_str(), 0640), 0);
  std::filesystem::create_symlink("real", folder / "link");
  auto sink = Sink::open(folder / "link");
  ASSERT_TRUE(sink);
  ASSERT_TRUE(sink->write("new"));
  ASSERT_TRUE(sink->close());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(contents(folder / "real"), "new");
  struct stat info {};
  ASSERT_EQ(stat((folder / "real").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0640u);
}

TEST(Sink, ALinkToAMissingFileStaysALink) {
  ScratchFolder folder;
  std::filesystem::create_directory(folder / "runs");
  std::filesystem::create_symlink("runs/newest", folder / "link");
  std::filesystem::create_symlink("link", folder / "link to it");
  auto sink = Sink::open(folder / "link to it");
  ASSERT_TRUE(sink);
  ASSERT_TRUE(sink->write("new"));
  ASSERT_TRUE(sink->close());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link to it"));
  EXPECT_EQ(contents(folder / "runs/newest"), "new");
}

TEST(Sink, AFullDiskIsAnErrorThatStays) {
  auto sink = Sink::open("/dev/full");
  ASSERT_TRUE(sink);
  const Status first = sink->write("x");
  ASSERT_FALSE(first);
  EXPECT_EQ(first.error().text(), "/dev/full: cannot write: No space left on device");
  EXPECT_TRUE(sink->failed());
  EXPECT_FALSE(sink->write("y"));
  EXPECT_FALSE(sink->flush());
  EXPECT_FALSE(sink->close());
  EXPECT_FALSE(isBrokenPipe(first.error()));
}

TEST(Sink, ABrokenPipeIsRecognised) {
  ScratchFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
  auto sink = Sink::open(path);
  ASSERT_TRUE(sink);
  close(reader);
  auto* before = signal(SIGPIPE, SIG_IGN);
  const Status status = sink->write("x");
  signal(SIGPIPE, before);
  ASSERT_FALSE(status);
  EXPECT_TRUE(isBrokenPipe(status.error()));
}

// Returns a sink of standard output, opened while descriptor 1 is `fd`.
Result<Sink> standardOutputTo(int fd) {
  std::fflush(stdout);
  const int before = dup(STDOUT_FILENO);
  dup2(fd, STDOUT_FILENO);
  auto sink = Sink::open("-");
  dup2(before, STDOUT_FILENO);
  close(before);
  return sink;
}

// Another process that shares the output can make it non-blocking.
TEST(Sink, WaitsOnANonBlockingOutput) {
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  ASSERT_EQ(fcntl(ends[1], F_SETFL, O_NONBLOCK), 0);
  std::string got;
  Status written;
  std::thread reader;
  {
    auto sink = standardOutputTo(ends[1]);
    close(ends[1]);
    ASSERT_TRUE(sink);
    reader = std::thread([&got, from = ends[0]] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));  // the pipe is full by then
      char buffer[4096];
      for (ssize_t n = 0; (n = read(from, buffer, sizeof buffer)) > 0;)
        got.append(buffer, size_t(n));
    });
    written = sink->write(std::string(size_t(1) << 20, 'x'));
  }
  reader.join();
  close(ends[0]);
  EXPECT_TRUE(written) << written.error().text();
  EXPECT_EQ(got.size(), size_t(1) << 20);
}

TEST(Sink, PipesGetEveryPieceAtOnce) {
  ScratchFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
  auto sink = Sink::open(path);
  ASSERT_TRUE(sink);
  ASSERT_TRUE(sink->write("a line\n"));
  char got[64];
  EXPECT_EQ(read(reader, got, 64), 7);
  close(reader);
}

TEST(Sink, AStopAbandonsAReaderThatReadsNothing) {
  ScratchFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::atomic<bool> stop{true};
  auto unread = Sink::open(path, Durable::no, &stop);
  ASSERT_FALSE(unread);
  EXPECT_TRUE(isInterrupted(unread.error()));
  EXPECT_EQ(unread.error().input, path);
  const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
  auto sink = Sink::open(path, Durable::no, &stop);
  ASSERT_TRUE(sink);
  EXPECT_TRUE(sink->write("what there is room for\n"));
  const Status status = sink->write(std::string(size_t(1) << 20, 'x'));
  close(reader);
  ASSERT_FALSE(status);
  EXPECT_TRUE(isInterrupted(status.error()));
  EXPECT_TRUE(sink->failed());
}

TEST(Sink, AStopAllowsASecondForAReaderToOpenThePipe) {
  ScratchFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const std::atomic<bool> stop{true};
  int reader = -1;
  std::thread late([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
  });
  auto sink = Sink::open(path, Durable::no, &stop);
  late.join();
  ASSERT_TRUE(sink) << sink.error().text();
  EXPECT_TRUE(sink->write("what there is room for\n"));
  close(reader);
}

// A reader that keeps reading gets the whole record, however long it is.
TEST(Sink, AStopWaitsForAReaderThatKeepsReading) {
  ScratchFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  size_t got = 0;
  std::thread reader([&] {
    const int from = open(path.c_str(), O_RDONLY);
    char buffer[4096];
    for (ssize_t n = 0; (n = read(from, buffer, sizeof buffer)) > 0;) got += size_t(n);
    close(from);
  });
  std::atomic<bool> stop{false};
  Status written;
  {
    auto sink = Sink::open(path, Durable::no, &stop);
    ASSERT_TRUE(sink);
    stop = true;
    written = sink->write(std::string(size_t(1) << 20, 'x'));
  }
  reader.join();
  EXPECT_TRUE(written) << written.error().text();
  EXPECT_EQ(got, size_t(1) << 20);
}

TEST(Sink, PlacesThatCannotBeWrittenAreNamed) {
  ScratchFolder folder;
  auto nowhere = Sink::open(folder / "no/where");
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().message, "cannot create: No such file or directory");
  auto directory = Sink::open(folder / "");
  ASSERT_FALSE(directory);
  EXPECT_EQ(directory.error().message, "cannot write: Is a directory");
  auto nameless = Sink::open("");  // open() fails at once, instead of at the end of the run
  ASSERT_FALSE(nameless);
  EXPECT_EQ(nameless.error().message, "the name of the output file is empty");
}

}  // namespace
}  // namespace obby::io
