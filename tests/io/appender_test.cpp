// Logs that go to a pipe: who is told to stop waits no longer for its reader.
#include "io/appender.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "io/read_file.h"
#include "scratch_folder.h"

namespace obby::io {
namespace {

TEST(Appender, WhoIsToldToStopGivesUpAReaderWhoTakesNothing) {
  test::ScratchFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
  std::atomic<bool> stop{false};
  auto log = Appender::open(path, &stop);
  ASSERT_TRUE(log) << log.error().text();
  EXPECT_TRUE(log->append("a row\n"));
  stop = true;
  EXPECT_TRUE(log->append("what there is room for\n"));
  const Status status = log->append(std::string(size_t(1) << 20, 'x'));
  close(reader);
  ASSERT_FALSE(status);
  EXPECT_TRUE(isInterrupted(status.error()));
  EXPECT_EQ(status.error().input, path);
}

// Not by a signal, which would break off a write that waits.
TEST(Appender, MayBeToldToStopWhileItWaits) {
  test::ScratchFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
  std::atomic<bool> stop{false};
  auto log = Appender::open(path, &stop);
  ASSERT_TRUE(log) << log.error().text();
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop = true;
  });
  const Status status = log->append(std::string(size_t(1) << 20, 'x'));
  other.join();
  close(reader);
  ASSERT_FALSE(status);
  EXPECT_TRUE(isInterrupted(status.error()));
}

}  // namespace
}  // namespace obby::io
