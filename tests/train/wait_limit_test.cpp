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
