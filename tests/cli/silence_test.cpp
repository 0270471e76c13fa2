// Tests a stream whose output is discarded for a while.
#include "cli/silence.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace obby::cli {
namespace {

TEST(Silence, DiscardsWhatIsWrittenWhileItLives) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  {
    const Silence silence(ends[1]);
    EXPECT_EQ(write(ends[1], "lost", 4), 4);
  }
  EXPECT_EQ(write(ends[1], "kept", 4), 4);
  char text[9] = {};
  EXPECT_EQ(read(ends[0], text, 8), 4);
  EXPECT_STREQ(text, "kept");
  for (const int end : ends) close(end);
}

}  // namespace
}  // namespace obby::cli
