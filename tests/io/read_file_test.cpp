// Tests reading of whole files, folders, and pipes with and without a writer. A stop or a signal
// interrupts reading.
#include "io/read_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <thread>

#include "scratch_folder.h"

namespace obby::io {
namespace {

using namespace std::chrono_literals;
using test::ScratchFolder;

struct Pipe {
  ScratchFolder folder;
  std::string path = folder / "pipe";
  Pipe() { EXPECT_EQ(mkfifo(path.c_str(), 0600), 0); }
};

TEST(ReadFile, ReturnsAllBytesAndNamesMissingFiles) {
  ScratchFolder folder;
  std::string bytes(3 << 20, 'x');
  for (size_t i = 0; i < bytes.size(); i += 7) bytes[i] = char(i / 7);
  std::ofstream(folder / "a", std::ios::binary) << bytes;
  std::ofstream(folder / "empty").flush();
  EXPECT_EQ(*readFile(folder / "a"), bytes);
  EXPECT_EQ(*readFile(folder / "empty"), "");
  EXPECT_EQ(readFile(folder / "b").error().text(),
            folder / "b: cannot open: No such file or directory");
  EXPECT_EQ(readFile(folder / "").error().message, "cannot read: Is a directory");
}

// An endless input would take all memory. A file whose stated size is too large is not read at all.
TEST(ReadFile, RefusesFilesAboveTheLimit) {
  ScratchFolder folder;
  std::ofstream(folder / "a") << std::string(2000, 'x');
  EXPECT_EQ(readFile(folder / "a", nullptr, 2000)->size(), 2000u);
  const std::string cure = " (this file is read into memory whole; give a smaller one)";
  EXPECT_EQ(readFile(folder / "a", nullptr, 1999).error().text(),
            folder / "a: expected at most 1999 bytes, found 2000" + cure);
  std::ofstream(folder / "sparse").flush();
  std::filesystem::resize_file(folder / "sparse", kMaxFileBytes + 1);
  EXPECT_EQ(readFile(folder / "sparse").error().text(),
            folder / "sparse: expected at most 1073741824 bytes, found 1073741825" + cure);
  const std::atomic<bool> stop{false};
  for (const std::atomic<bool>* stopFlag :
       {static_cast<const std::atomic<bool>*>(nullptr), &stop}) {
    EXPECT_EQ(readFile("/dev/zero", stopFlag, 1 << 20).error().text(),
              "/dev/zero: expected at most 1048576 bytes, found more" + cure);
  }
}

double threadSeconds() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return double(used.tv_sec) + 1e-9 * double(used.tv_nsec);
}

// Another process that shares the input can make it non-blocking. Polling it in a loop would take a
// whole core.
TEST(ReadFile, WaitsOnANonBlockingInput) {
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  ASSERT_EQ(fcntl(ends[0], F_SETFL, O_NONBLOCK), 0);
  const int before = dup(STDIN_FILENO);
  dup2(ends[0], STDIN_FILENO);
  std::thread writer([to = ends[1]] {
    std::this_thread::sleep_for(400ms);
    EXPECT_EQ(::write(to, "late", 4), 4);
    close(to);
  });
  const double begin = threadSeconds();
  const auto bytes = readFile("-");
  const double used = threadSeconds() - begin;
  writer.join();
  dup2(before, STDIN_FILENO);
  close(before);
  close(ends[0]);
  ASSERT_TRUE(bytes) << bytes.error().text();
  EXPECT_EQ(*bytes, "late");
  EXPECT_LT(used, 0.1);
}

TEST(ReadFile, WaitsForAWriterAndReadsToTheEnd) {
  for (const bool mayStop : {false, true}) {
    const Pipe pipe;
    const std::atomic<bool> stop{false};
    std::thread writer([&] {
      std::this_thread::sleep_for(20ms);
      std::ofstream(pipe.path) << std::string(300000, 'x');
    });
    const auto bytes = readFile(pipe.path, mayStop ? &stop : nullptr);
    writer.join();
    ASSERT_TRUE(bytes) << bytes.error().text();
    EXPECT_EQ(bytes->size(), 300000u);
  }
}

TEST(ReadFile, AStopEndsTheWait) {
  for (const bool hasWriter : {false, true}) {
    const Pipe pipe;
    const int writer = hasWriter ? open(pipe.path.c_str(), O_RDWR) : -1;
    if (hasWriter) {
      ASSERT_EQ(::write(writer, "half", 4), 4);
    }
    std::atomic<bool> stop{false};
    std::thread stopper([&] {
      std::this_thread::sleep_for(50ms);
      stop = true;
    });
    const auto bytes = readFile(pipe.path, &stop);
    stopper.join();
    close(writer);
    ASSERT_FALSE(bytes);
    EXPECT_TRUE(isInterrupted(bytes.error()));
    EXPECT_EQ(bytes.error().input, pipe.path);
  }
}

void onSignal(int) {}

TEST(ReadFile, ASignalEndsTheWaitWithoutAStop) {
  struct sigaction action {};
  action.sa_handler = onSignal;
  ASSERT_EQ(sigaction(SIGUSR1, &action, nullptr), 0);
  for (const bool hasWriter : {false, true}) {
    const Pipe pipe;
    const int writer = hasWriter ? open(pipe.path.c_str(), O_RDWR) : -1;
    std::atomic<bool> done{false};
    std::optional<Result<std::string>> bytes;
    std::thread reader([&] {
      bytes = readFile(pipe.path);
      done = true;
    });
    while (!done) {  // repeats, since the first signal may come before the wait
      pthread_kill(reader.native_handle(), SIGUSR1);
      std::this_thread::sleep_for(5ms);
    }
    reader.join();
    close(writer);
    ASSERT_FALSE(*bytes);
    EXPECT_TRUE(isInterrupted(bytes->error()));
  }
}

}  // namespace
}  // namespace obby::io
