// A stream that sends nothing is waited for as long as there is time.
#include "train/wait_limit.h"

#include <gtest/gtest.h>

#include "train/level_lines.h"
#include "train/standing.h"

namespace obby::train {
namespace {

using std::chrono::milliseconds;

TEST(WaitLimit, EndsALevelStreamThatSendsNoMore) {
  const Standing standing(kHeaderLine + lineOf(0) + lineOf(1));
  const LevelStream all(optionsOf(linesOf(2)));
  const std::atomic<bool> interrupted{false};
  WaitLimit waiting(interrupted, 0.5, 0.5);
  const LevelStream stream(standing.options(waiting), {.choices = 1, .wait = &waiting});
  EXPECT_EQ(hashOf(stream, 0), hashOf(all, 0));
  waiting.begin();
  EXPECT_EQ(hashOf(stream, 1), hashOf(all, 1));
  EXPECT_FALSE(waiting.isUp());
  const auto none = stream.level(2, 1);
  ASSERT_TRUE(none) << none.error().text();
  EXPECT_EQ(*none, nullptr) << "and not the first again";
  EXPECT_TRUE(waiting.isUp());
}

// As where the levels that come next are made while others are played.
TEST(LevelStream, IsToldWhatIsPastWhileItIsWaitedFor) {
  const Standing standing(kHeaderLine + lineOf(0) + lineOf(1));
  const std::atomic<bool> interrupted{false};
  WaitLimit waiting(interrupted, 10, 0);
  const LevelStream stream(standing.options(waiting), {.keptBytes = 1, .wait = &waiting});
  hashOf(stream, 1);
  std::thread other([&] {
    const auto none = stream.level(2, 1);
    EXPECT_TRUE(none && !*none);
  });
  std::this_thread::sleep_for(milliseconds(200));
  stream.past(2);
  EXPECT_FALSE(waiting.isUp());
  waiting.end();
  other.join();
  EXPECT_FALSE(stream.level(1, 1)) << "it is past";
}

TEST(WaitLimit, DoesNotPassWhileNobodyReads) {
  const std::atomic<bool> interrupted{false};
  WaitLimit waiting(interrupted, 0, 0.05);
  waiting.begin();
  std::this_thread::sleep_for(milliseconds(200));
  EXPECT_FALSE(bool(waiting.stop()));
  const Standing standing("");
  io::RecordSource source(standing.options(waiting));
  const auto record = waiting.next(source);
  ASSERT_TRUE(record) << record.error().text();
  EXPECT_FALSE(*record);
  EXPECT_TRUE(waiting.isUp());
}

// Readers of what is written are not waited for any more then.
TEST(WaitLimit, IsLateOnceTheWorkHasLastedItsTime) {
  const std::atomic<bool> interrupted{false};
  WaitLimit waiting(interrupted, 0.05);
  std::this_thread::sleep_for(milliseconds(200));
  EXPECT_FALSE(bool(waiting.late())) << "it has not begun";
  waiting.begin();
  for (int i = 0; i < 1000 && !waiting.late(); ++i) std::this_thread::sleep_for(milliseconds(10));
  EXPECT_TRUE(bool(waiting.late()));
  EXPECT_FALSE(bool(waiting.stop())) << "nobody reads";
  EXPECT_FALSE(bool(waiting.lost())) << "that comes ten seconds later";
}

// As where a log's reader came in the last second of the time that it had.
TEST(WaitLimit, IsNotLateWhereTheWorkBeginsAnew) {
  const std::atomic<bool> interrupted{false};
  WaitLimit waiting(interrupted, 1);
  waiting.begin();
  for (int i = 0; i < 1000 && !waiting.late(); ++i) std::this_thread::sleep_for(milliseconds(10));
  EXPECT_TRUE(bool(waiting.late()));
  waiting.begin();
  EXPECT_FALSE(bool(waiting.late()));
}

TEST(WaitLimit, IsLateAfterASignal) {
  const std::atomic<bool> interrupted{true};
  WaitLimit waiting(interrupted, WaitLimit::kNone);
  for (int i = 0; i < 1000 && !waiting.late(); ++i) std::this_thread::sleep_for(milliseconds(10));
  EXPECT_TRUE(bool(waiting.late()));
}

// What is read ahead is not waited for once nobody needs it, nor after a signal.
TEST(WaitLimit, EndsWithTheWorkAndWithASignal) {
  for (const bool bySignal : {false, true}) {
    std::atomic<bool> interrupted{false};
    WaitLimit waiting(interrupted, WaitLimit::kNone);
    const Standing standing("");
    std::thread other([&] {
      std::this_thread::sleep_for(milliseconds(50));
      if (bySignal) {
        interrupted = true;
      } else {
        waiting.end();
      }
    });
    io::RecordSource source(standing.options(waiting));
    const auto record = waiting.next(source);
    other.join();
    ASSERT_TRUE(record) << record.error().text();
    EXPECT_FALSE(*record);
    EXPECT_FALSE(waiting.isUp());
  }
}

}  // namespace
}  // namespace obby::train
