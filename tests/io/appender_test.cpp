// A log that waits for the reader of its pipe stops waiting on request.
#include "io/appender.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <thread>

#include "io/read_file.h"
#include "scratch_folder.h"

namespace obby::io {
namespace {

// A log to a pipe that is never read.
class StalledLog : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
    auto opened = Appender::open(path, &stop);
    ASSERT_TRUE(opened) << opened.error().text();
    log.emplace(*std::move(opened));
  }
  ~StalledLog() override { close(reader); }

  test::ScratchFolder folder;
  const std::string path = folder / "pipe";
  int reader = -1;
  std::atomic<bool> stop{false};
  std::optional<Appender> log;
};

TEST_F(StalledLog, AStopAbandonsAReaderThatReadsNothing) {
  EXPECT_TRUE(log->append("a row\n"));
  stop = true;
  EXPECT_TRUE(log->append("what there is room for\n"));
  const Status status = log->append(std::string(size_t(1) << 20, 'x'));
  ASSERT_FALSE(status);
  EXPECT_TRUE(isInterrupted(status.error()));
  EXPECT_EQ(status.error().input, path);
}

// A real signal would interrupt a blocked write, so this test only sets the flag.
TEST_F(StalledLog, AStopEndsAWaitingWrite) {
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop = true;
  });
  const Status status = log->append(std::string(size_t(1) << 20, 'x'));
  other.join();
  ASSERT_FALSE(status);
  EXPECT_TRUE(isInterrupted(status.error()));
}

}  // namespace
}  // namespace obby::io
