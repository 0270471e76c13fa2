// Logs of learning: what stays of them when learning goes on, what others read, and what comes of
// rows that a disk has no room for.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include "io/read_file.h"
#include "train/csv_log.h"
#include "train/event_log.h"
#include "train/history.h"

namespace obby::train {
namespace {

// While it lives no file of this process grows beyond so many bytes, as on a disk that is full.
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

class CsvLogs : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove(path_); }
  void TearDown() override { std::filesystem::remove(path_); }

  // Rows for these iterations behind those up to `kept`.
  void write(uint64_t kept, std::vector<uint64_t> iterations) {
    auto log = CsvLog::open(path_, kept);
    ASSERT_TRUE(log) << log.error().text();
    for (const uint64_t i : iterations) ASSERT_TRUE(add(*log, i));
  }
  static Status add(CsvLog& log, uint64_t number) {
    Iteration iteration;
    iteration.decisions = 100 * number;
    return log.add(number, metricsOf(iteration, 7, 8));
  }
  std::string text() const { return *io::readFile(path_); }

  std::string path_ = testing::TempDir() + "obby_csv_log_test_" +
                      testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv";
};

TEST_F(CsvLogs, GoOnBehindWhatIsKept) {
  write(0, {1, 2, 3, 4});
  const std::string whole = text();
  EXPECT_EQ(whole.substr(0, whole.find(',')), "iteration");
  EXPECT_NE(whole.find(",seconds,decisionsPerSecond\n1,100,"), std::string::npos) << whole;
  write(2, {3, 4});
  EXPECT_EQ(text(), whole);
  std::ofstream(path_, std::ios::app) << "5,50";  // cut by a kill
  write(4, {});
  EXPECT_EQ(text(), whole);
  write(0, {1});
  EXPECT_EQ(text(), whole.substr(0, text().size())) << "it begins anew";
  EXPECT_LT(text().size(), whole.size());
}

// As mktemp makes one.
TEST_F(CsvLogs, BeginInAFileThatIsEmptyWhereverLearningIs) {
  write(0, {4});
  const std::string whole = text();
  std::ofstream(path_, std::ios::trunc);
  ASSERT_EQ(text(), "");
  write(3, {4});
  EXPECT_EQ(text(), whole);
}

TEST_F(CsvLogs, AreNotMadeOfOtherFiles) {
  std::ofstream(path_) << "my notes\n";
  const auto log = CsvLog::open(path_, 3);
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().input, path_);
  EXPECT_EQ(text(), "my notes\n");
}

TEST_F(CsvLogs, WaitForRoomOnADiskThatIsFull) {
  write(0, {1, 2, 3, 4});
  const std::string whole = text();
  auto log = CsvLog::open(path_, 0);
  ASSERT_TRUE(log) << log.error().text();
  ASSERT_TRUE(add(*log, 1));
  const std::string before = text();
  {
    const FullDisk full(before.size() + 9);  // a part of a row
    EXPECT_TRUE(add(*log, 2));
    EXPECT_TRUE(add(*log, 3));
    EXPECT_FALSE(log->file().held());
    const Status missing = log->file().finish();
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().text().find("missing at its end: 2"), std::string::npos)
        << missing.error().text();
    EXPECT_EQ(text(), before) << "whole rows only";
  }
  EXPECT_TRUE(add(*log, 4));
  EXPECT_TRUE(log->file().held());
  EXPECT_TRUE(log->file().finish());
  EXPECT_EQ(text(), whole);
}

TEST_F(CsvLogs, DoNotWaitForEverNorForPipes) {
  auto file = io::Appender::open(path_), device = io::Appender::open("/dev/full");
  ASSERT_TRUE(file && device);
  PatientLog patient(*std::move(file)), other(*std::move(device));
  const FullDisk full(0);
  EXPECT_FALSE(other.add("row\n"));
  EXPECT_TRUE(patient.add("row\n"));
  EXPECT_FALSE(patient.add(std::string(PatientLog::kMostBytes, 'x')));
}

// The check values of RFC 3720, B.4, and of the polynomial's registry.
TEST(EventLogs, ChecksumsAreThoseOfTheStandard) {
  EXPECT_EQ(crc32c("123456789"), 0xe3069283u);
  EXPECT_EQ(crc32c(std::string(32, '\0')), 0x8a9136aau);
  EXPECT_EQ(crc32c(std::string(32, '\xff')), 0x62a8ab43u);
}

// TensorBoard drops what it has from the step on at which a session log says start: the one behind
// the last that is kept.
TEST(EventLogs, BeginBehindWhatIsKept) {
  const std::string folder = testing::TempDir() + "obby_event_log_test";
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(EventLog::open(folder, 7));
  std::string bytes;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    bytes += *io::readFile(entry.path().string());
  std::filesystem::remove_all(folder);
  // Of an Event: step (field 2) 8, session_log (field 7) of two bytes: status (field 1) START, 1.
  EXPECT_NE(bytes.find("\x10\x08\x3a\x02\x08\x01"), std::string::npos);
}

TEST(Histories, BecomeCoarserInsteadOfLonger) {
  History history;
  Iteration iteration;
  for (int i = 1; i <= 5000; ++i) {
    iteration.decisions = uint64_t(i) * 10;
    iteration.reward = i % 2;
    iteration.solved = i / 5000.0;
    history.add(iteration);
  }
  EXPECT_LT(history.points.size(), History::kMostPoints);
  EXPECT_GT(history.points.size(), History::kMostPoints / 4);
  EXPECT_EQ(history.each, 8u);
  for (size_t i = 0; i < history.points.size(); ++i) {
    EXPECT_EQ(history.points[i].decisions, (i + 1) * 80);
    EXPECT_FLOAT_EQ(history.points[i].reward, 0.5f);
  }
  EXPECT_NE(curveSvg(history).find("40 k"), std::string::npos);
  EXPECT_NE(curveSvg({}).find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace obby::train
