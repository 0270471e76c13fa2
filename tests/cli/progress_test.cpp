// Progress lines: their mode and their content.
#include "cli/progress.h"

#include <gtest/gtest.h>

#include <cmath>

namespace obby::cli {
namespace {

TEST(Progress, ModesFollowTheTerminalAndTheUser) {
  EXPECT_EQ(progressMode("auto", true, false), ProgressMode::bar);
  EXPECT_EQ(progressMode("auto", false, false), ProgressMode::none);
  EXPECT_EQ(progressMode("line", false, false), ProgressMode::line);
  EXPECT_EQ(progressMode("line", true, false), ProgressMode::bar);
  EXPECT_EQ(progressMode("json", true, false), ProgressMode::json);
  EXPECT_EQ(progressMode("none", true, false), ProgressMode::none);
  EXPECT_EQ(progressMode("auto", true, true), ProgressMode::none);
  EXPECT_EQ(progressMode("json", true, true), ProgressMode::json);
}

TEST(Progress, LinesAreShortAndNumbersBrief) {
  const ProgressState state{"query a", 0.426, {{"steps", 1234567890}, {"cells", 471}, {"m", 1.25}}};
  EXPECT_EQ(progressLine(state, 80), "query a  43 %  steps 1.23G  cells 471  m 1.25");
  EXPECT_EQ(progressLine(state, 9), "query a  ");
  EXPECT_EQ(progressLine({"x", -1, {}}, 80), "x");
}

TEST(Progress, ShowsTheTimeLeftInWords) {
  const auto lineOf = [](double seconds) { return progressLine({"x", -1, {}, seconds}, 80); };
  EXPECT_EQ(lineOf(0), "x  0 s left");
  EXPECT_EQ(lineOf(59.9), "x  59 s left");
  EXPECT_EQ(lineOf(725), "x  12 min left");
  EXPECT_EQ(lineOf(12400), "x  3 h 26 min left");
  EXPECT_EQ(lineOf(3600), "x  1 h 0 min left");
  EXPECT_EQ(lineOf(400000), "x  4.63 days left");
  EXPECT_EQ(lineOf(-1), "x");
  EXPECT_EQ(lineOf(INFINITY), "x");
  EXPECT_EQ(progressJson({"x", -1, {}, 12400.5}),
            "{\"type\":\"progress\",\"task\":\"x\",\"seconds left\":12400.5}");
}

// Ids come from untrusted streams.
TEST(Progress, LinesMoveNoCursorAndEndWithAWholeCharacter) {
  EXPECT_EQ(progressLine({"query \x1b[2J\n\xe9", -1, {}}, 80), "query ?[2J?\xef\xbf\xbd");
  EXPECT_EQ(progressLine({"caf\xc3\xa9", -1, {}}, 5), "caf\xc3\xa9");
  EXPECT_EQ(progressLine({"caf\xc3\xa9", -1, {}}, 4), "caf");
}

TEST(Progress, JsonHasExactNumbersButNoNaNOrInfinity) {
  const ProgressState state{"say \"hi\"\n", 0.5, {{"steps", 1234567890}, {"bad", NAN}}};
  EXPECT_EQ(progressJson(state),
            "{\"type\":\"progress\",\"task\":\"say \\\"hi\\\"\\n\",\"fraction\":0.5,"
            "\"steps\":1234567890}");
}

}  // namespace
}  // namespace obby::cli
