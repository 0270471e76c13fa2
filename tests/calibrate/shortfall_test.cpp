// Reasons why a fit stays above the tolerance.
#include "calibrate/shortfall.h"

#include <gtest/gtest.h>

#include "calibrate/course.h"

namespace obby::calibrate {
namespace {

// Returns a fit of one parameter that is still unknown.
Fit shortfallFitOf(const std::string& name) {
  Fit out;
  const Parameter p = parametersNamed({name}, defaults())->front();
  out.parameters.push_back({p, valueOf(defaults(), name), p.lowest, p.highest});
  return out;
}

Shortfall shortfall(const std::vector<Take>& takes, const Fit& fit, double tolerance) {
  auto out = shortfallOf(takes, fit, defaults(), tolerance);
  EXPECT_TRUE(out) << out.error().text();
  return *std::move(out);
}

TEST(Shortfall, NoiseOfThePositionsIsMeasured) {
  const auto takes = takesUnder(defaults(), 0.2f, firstManoeuvres(3));
  const Shortfall s = shortfall(takes, shortfallFitOf("walkSpeed"), 0.01);
  EXPECT_NEAR(s.noise, 0.19, 0.02) << "of a cube of 0.2 to each side";
  EXPECT_NE(shortOf(s, 0.01).find("jitter"), std::string::npos);
}

// The recorded player walks faster, which no gravity can explain.
TEST(Shortfall, NamesRecordingsThatNoParameterExplains) {
  io::RecordBuilder truth;
  setValue(truth.root().initParams(), "walkSpeed", 24);
  const auto takes = takesUnder(truth.reader().getParams(), 0, firstManoeuvres(2));
  const Shortfall s = shortfall(takes, shortfallFitOf("gravity"), 0.05);
  ASSERT_FALSE(s.strange.empty());
  EXPECT_EQ(s.strange[0].recording, "run, stop, turn");
  EXPECT_EQ(s.strange[0].state, sim::State::running);
  EXPECT_TRUE(s.strange[0].untold.empty());
  EXPECT_NE(reasonsOf(s, 0.05).at(0).find("with any parameter values"), std::string::npos);
}

// Held-out recordings can depend on a parameter that no fitted recording determines.
TEST(Shortfall, NamesParametersThatTheFittedRecordingsDoNotDetermine) {
  io::RecordBuilder truth;
  setValue(truth.root().initParams(), "landedTime", 0.1);
  const auto all = takesUnder(truth.reader().getParams(), 0, firstManoeuvres(4));
  const Shortfall s = shortfall({all[3]}, shortfallFitOf("landedTime"), 0.05);
  ASSERT_FALSE(s.strange.empty());
  EXPECT_EQ(s.strange[0].untold, std::vector<std::string>{"landedTime"});
  EXPECT_NE(shortOf(s, 0.05).find("do not determine landedTime"), std::string::npos);
}

TEST(Shortfall, NamesParametersAtAnEnd) {
  Fit fit = shortfallFitOf("walkSpeed");
  Fitted& f = fit.parameters[0];
  f.value = f.high = f.parameter.highest;
  f.low = 31;
  const auto takes = takesUnder(defaults(), 0, firstManoeuvres(2));
  const Shortfall s = shortfall(takes, fit, 0.1);
  EXPECT_EQ(s.ends, std::vector<std::string>{"walkSpeed"});
  EXPECT_TRUE(s.strange.empty()) << "the recordings are followed";
}

// Times of zero ticks and accelerations of zero are valid results. These values do not count as
// ends of a range.
TEST(Shortfall, ZeroIsNotTheEndOfARange) {
  const auto takes = takesUnder(defaults(), 0, firstManoeuvres(2));
  Fit none = shortfallFitOf("landedTime");
  Fitted& f = none.parameters[0];
  f.value = f.low = f.high = 0;
  f.tick = 1 / 60.0;
  EXPECT_TRUE(shortfall(takes, none, 0.1).ends.empty());
  none = shortfallFitOf("jumpAccel");
  none.parameters[0].high = 1;
  EXPECT_TRUE(shortfall(takes, none, 0.1).ends.empty());
}

// Two takes have the same name. The simulator follows the first one under any parameters, but not
// the second.
TEST(Shortfall, RecordingsWithTheSameNameAreDistinguished) {
  io::RecordBuilder fast;
  setValue(fast.root().initParams(), "walkSpeed", 24);
  auto takes = takesUnder(defaults(), 0, firstManoeuvres(1));
  const auto second = takesUnder(fast.reader().getParams(), 0, firstManoeuvres(1));
  takes.insert(takes.end(), second.begin(), second.end());
  const Shortfall s = shortfall(takes, shortfallFitOf("landedTime"), 0.05);
  ASSERT_FALSE(s.strange.empty());
  EXPECT_EQ(s.strange[0].take, 1u);
  EXPECT_TRUE(s.strange[0].untold.empty());
}

// An interrupted fit may not have tried a parameter, so the report does not blame a recording.
TEST(Shortfall, NamesTheInterruptionOfAFit) {
  io::RecordBuilder truth;
  setValue(truth.root().initParams(), "walkSpeed", 24);
  const auto takes = takesUnder(truth.reader().getParams(), 0, firstManoeuvres(2));
  Fit fit = shortfallFitOf("gravity");
  fit.stopped = true;
  const Shortfall s = shortfall(takes, fit, 0.05);
  EXPECT_TRUE(s.strange.empty());
  EXPECT_EQ(shortOf(s, 0.05), "the fit was interrupted");
  EXPECT_EQ(reasonsOf(s, 0.05), std::vector<std::string>{"the fit was interrupted"});
}

}  // namespace
}  // namespace obby::calibrate
