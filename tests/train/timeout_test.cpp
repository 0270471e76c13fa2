// Time limits of streams that send nothing, and of readers that stall.
#include "train/timeout.h"

#include <gtest/gtest.h>

#include "train/level_lines.h"
#include "train/standing.h"

namespace obby::train {
namespace {

using std::chrono::milliseconds;

TEST(Timeout, EndsAStalledStream) {
  const Standing standing(kHeaderLine + lineOf(0) + lineOf(1));
  const LevelStream all(optionsOf(linesOf(2)));
  const std::atomic<bool> interrupted{false};
  Timeout timeout(interrupted, 0.5, 0.5);
  const LevelStream stream(standing.options(timeout), {.choices = 1, .timeout = &timeout});
  EXPECT_EQ(hashOf(stream, 0), hashOf(all, 0));
  timeout.begin();
  EXPECT_EQ(hashOf(stream, 1), hashOf(all, 1));
  EXPECT_FALSE(timeout.expired());
  const auto none = stream.level(2, 1);
  ASSERT_TRUE(none) << none.error().text();
  EXPECT_EQ(*none, nullptr) << "not the first level again";
  EXPECT_TRUE(timeout.expired());
}

// Another thread makes the next levels while the current ones are played.
TEST(LevelStream, DropsPastLevelsWhileAnotherThreadWaits) {
  const Standing standing(kHeaderLine + lineOf(0) + lineOf(1));
  const std::atomic<bool> interrupted{false};
  Timeout timeout(interrupted, 10, 0);
  const LevelStream stream(standing.options(timeout), {.keptBytes = 1, .timeout = &timeout});
  hashOf(stream, 1);
  std::thread other([&] {
    const auto none = stream.level(2, 1);
    EXPECT_TRUE(none && !*none);
  });
  std::this_thread::sleep_for(milliseconds(200));
  stream.past(2);
  EXPECT_FALSE(timeout.expired());
  timeout.end();
  other.join();
  EXPECT_FALSE(stream.level(1, 1)) << "level 1 is past";
}

TEST(Timeout, DoesNotExpireWhileNoThreadReads) {
  const std::atomic<bool> interrupted{false};
  Timeout timeout(interrupted, 0, 0.05);
  timeout.begin();
  std::this_thread::sleep_for(milliseconds(200));
  EXPECT_FALSE(bool(timeout.stop()));
  const Standing standing("");
  io::RecordSource source(standing.options(timeout));
  const auto record = timeout.next(source);
  ASSERT_TRUE(record) << record.error().text();
  EXPECT_FALSE(*record);
  EXPECT_TRUE(timeout.expired());
}

// Once the work is late, outputs no longer wait for their readers.
TEST(Timeout, IsLateOnceTheWorkHasTakenItsTime) {
  const std::atomic<bool> interrupted{false};
  Timeout timeout(interrupted, 0.05);
  std::this_thread::sleep_for(milliseconds(200));
  EXPECT_FALSE(bool(timeout.late())) << "it has not begun";
  timeout.begin();
  for (int i = 0; i < 1000 && !timeout.late(); ++i) std::this_thread::sleep_for(milliseconds(10));
  EXPECT_TRUE(bool(timeout.late()));
  EXPECT_FALSE(bool(timeout.stop())) << "no thread reads";
}

TEST(Timeout, IsLateAfterASignal) {
  const std::atomic<bool> interrupted{true};
  Timeout timeout(interrupted, Timeout::kNone);
  for (int i = 0; i < 1000 && !timeout.late(); ++i) std::this_thread::sleep_for(milliseconds(10));
  EXPECT_TRUE(bool(timeout.late()));
}

// A thread that reads ahead stops waiting at the end of the work, and after a signal.
TEST(Timeout, EndsWithTheWorkAndWithASignal) {
  for (const bool bySignal : {false, true}) {
    std::atomic<bool> interrupted{false};
    Timeout timeout(interrupted, Timeout::kNone);
    const Standing standing("");
    std::thread other([&] {
      std::this_thread::sleep_for(milliseconds(50));
      if (bySignal) {
        interrupted = true;
      } else {
        timeout.end();
      }
    });
    io::RecordSource source(standing.options(timeout));
    const auto record = timeout.next(source);
    other.join();
    ASSERT_TRUE(record) << record.error().text();
    EXPECT_FALSE(*record);
    EXPECT_FALSE(timeout.expired());
  }
}

}  // namespace
}  // namespace obby::train
