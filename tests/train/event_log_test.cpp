// The log for TensorBoard: its format, and events that a full disk delays.
#include "train/run/event_log.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <filesystem>

#include "io/read_file.h"

namespace obby::train {
namespace {

// While this object exists, no file of this process can grow beyond `bytes` bytes, as on a full
// disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit full{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

class EventLogs : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove_all(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  // Returns the contents of all files in the folder.
  std::string bytes() const {
    std::string out;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      out += *io::readFile(entry.path().string());
    return out;
  }

  std::string folder_ = testing::TempDir() + "obby_event_log_test_" +
                        testing::UnitTest::GetInstance()->current_test_info()->name();
};

// The check values of RFC 3720, B.4, and of the registry of polynomials.
TEST(Crc32c, MatchesTheStandardsCheckValues) {
  EXPECT_EQ(crc32c("123456789"), 0xe3069283u);
  EXPECT_EQ(crc32c(std::string(32, '\0')), 0x8a9136aau);
  EXPECT_EQ(crc32c(std::string(32, '\xff')), 0x62a8ab43u);
}

// TensorBoard drops earlier events from the step at which a session starts.
TEST_F(EventLogs, AResumedSessionStartsAfterTheKeptIteration) {
  ASSERT_TRUE(EventLog::open(folder_, 7));
  // An Event with step (field 2) = 8. Its session_log (field 7) has two bytes: status (field 1) =
  // START (1).
  EXPECT_NE(bytes().find("\x10\x08\x3a\x02\x08\x01"), std::string::npos);
}

TEST_F(EventLogs, EventsCarryTheMetricsNames) {
  auto log = EventLog::open(folder_, 0);
  ASSERT_TRUE(log) << log.error().text();
  log->add(3, metricsOf({}, 1, 2));
  EXPECT_TRUE(log->finish());
  for (const char* tag : {"train/approxKl", "train/clipFraction", "train/valueLoss",
                          "train/gradNorm", "train/entropy", "train/decisionsPerSecond"})
    EXPECT_NE(bytes().find(tag), std::string::npos) << tag;
}

TEST_F(EventLogs, EventsWaitUntilAFullDiskHasSpace) {
  const Metric metric[] = {{"solved", 0.5, ""}};
  auto log = EventLog::open(folder_, 0);
  ASSERT_TRUE(log) << log.error().text();
  log->add(1, metric);
  EXPECT_TRUE(log->held());
  const std::string before = bytes();
  {
    const FullDisk full(before.size() + 9);  // space for a part of an event
    log->add(2, metric);
    log->add(3, metric);
    EXPECT_FALSE(log->held());
    const Status missing = log->finish();
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().text().find("events missing at the end of the log: 2"),
              std::string::npos)
        << missing.error().text();
    EXPECT_EQ(bytes(), before) << "only whole events are written";
  }
  log->add(4, metric);
  EXPECT_TRUE(log->held());
  EXPECT_TRUE(log->finish());
  const std::string after = bytes();
  size_t events = 0;
  for (size_t at = 0; (at = after.find("train/solved", at)) != std::string::npos; ++at) ++events;
  EXPECT_EQ(events, 4u);
}

}  // namespace
}  // namespace obby::train
