// A stream that sends nothing is waited for as long as there is time.
#include "train/wait_limit.h"

#include <unistd.h>

#include "train/level_lines.h"

namespace obby::train {
namespace {

using std::chrono::milliseconds;

// A stream that stands still behind what was put into it.
class Standing {
 public:
  explicit Standing(const std::string& text) {
    EXPECT_EQ(pipe(ends_), 0);
    EXPECT_EQ(write(ends_[1], text.data(), text.size()), ssize_t(text.size()));
  }
  ~Standing() {
    for (const int end : ends_) close(end);
  }
  Standing(const Standing&) = delete;
  Standing& operator=(const Standing&) = delete;

  io::SourceOptions options(const WaitLimit& waiting) const {
    io::SourceOptions out;
    out.inputs = {fmt::format("/dev/fd/{}", ends_[0])};
    out.stop = &waiting.stop();
    return out;
  }

 private:
  int ends_[2] = {-1, -1};
};

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
