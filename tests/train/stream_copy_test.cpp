// The copy of a stream that only the first of several ranks can read.
#include "train/stream_copy.h"

#include <gtest/gtest.h>

#include "train/level_lines.h"

namespace obby::train {
namespace {

TEST(StreamCopy, HasTheSameLevelsAsTheStream) {
  const std::atomic<bool> interrupted{false};
  Timeout timeout(interrupted, Timeout::kNone);
  const auto copy = copyOfStream(optionsOf(linesOf(4)), timeout);
  ASSERT_TRUE(copy) << copy.error().text();
  const LevelStream all(optionsOf(linesOf(4))), copied(optionsOf(copy->records));
  for (uint64_t i = 0; i < 4; ++i) EXPECT_EQ(hashOf(copied, i), hashOf(all, i)) << i;
}

// An endless stream would take all memory before training starts.
TEST(StreamCopy, OfATooLongStreamIsAnError) {
  const std::atomic<bool> interrupted{false};
  Timeout timeout(interrupted, Timeout::kNone);
  const std::string lines = linesOf(4);
  const auto whole = copyOfStream(optionsOf(lines), timeout);
  ASSERT_TRUE(whole) << whole.error().text();
  const size_t bytes = whole->records.size();
  EXPECT_TRUE(copyOfStream(optionsOf(lines), timeout, bytes));
  const auto cut = copyOfStream(optionsOf(lines), timeout, bytes - 1);
  ASSERT_FALSE(cut);
  EXPECT_NE(cut.error().text().find("give fewer levels"), std::string::npos) << cut.error().text();
}

}  // namespace
}  // namespace obby::train
