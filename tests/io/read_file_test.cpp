// Whole files: from folders, pipes and pipes without a writer; broken off by a stop or a signal.
#include "io/read_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
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

TEST(ReadFile, GivesEveryByteAndNamesWhatIsMissing) {
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
      ASSERT_EQ(write(writer, "half", 4), 4);
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

TEST(ReadFile, WithoutAStopASignalEndsTheWait) {
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
    while (!done) {  // the first may come before it waits
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
