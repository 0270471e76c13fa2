// Parameters that made a recording are found again from it, and what it cannot tell is said.
#include "calibrate/fit.h"

#include <gtest/gtest.h>

#include "base/random.h"

#include "calibrate/course.h"

namespace obby::calibrate {
namespace {

const std::vector<std::string> kFitted = {"walkSpeed", "groundAccel", "airAccel",    "gravity",
                                          "jumpSpeed", "hipHeight",   "iceFriction", "climbSpeed"};

// The first of the manoeuvres show all of these.
constexpr size_t kEnough = 9;

// Others than the simulator's own, drawn within a share of them.
io::RecordBuilder drawn(uint64_t seed) {
  io::RecordBuilder out;
  auto params = out.root().initParams();
  Random random(seed, 0);
  for (const std::string& name : kFitted) {
    const double spread = name == "hipHeight" ? 0.1 : 0.3;
    setValue(params, name, valueOf(defaults(), name) * (1 + spread * (2 * random.unit() - 1)));
  }
  return out;
}

Fit fitted(const std::vector<Take>& takes, const std::vector<std::string>& names) {
  ThreadPool pool(availableThreads());
  const std::atomic<bool> stop{false};
  FitSettings settings;
  settings.restarts = 1;
  auto out = fit(takes, *parametersNamed(names, defaults()), defaults(), settings, pool, stop,
                 [](uint32_t, uint32_t, double) {});
  EXPECT_TRUE(out) << out.error().text();
  return *std::move(out);
}

class Drawn : public testing::TestWithParam<uint64_t> {};

TEST_P(Drawn, ParametersAreFoundAgain) {
  const io::RecordBuilder truth = drawn(GetParam());
  const Fit found = fitted(takesUnder(truth.reader().getParams(), 0, kEnough), kFitted);
  EXPECT_LT(found.loss, 1e-4 * found.lossBefore);
  for (const Fitted& f : found.parameters) {
    const double value = valueOf(truth.reader().getParams(), f.parameter.name);
    EXPECT_NEAR(f.value, value, 0.01 * value) << f.parameter.name;
    EXPECT_TRUE(f.known) << f.parameter.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, Drawn, testing::Values(1, 2));

TEST(Fit, SaysWhatNoRecordingShows) {
  io::RecordBuilder truth;
  setValue(truth.root().initParams(), "walkSpeed", 18);
  std::vector<Take> takes = takesUnder(truth.reader().getParams());
  takes.erase(takes.begin() + 2, takes.end());  // nobody climbs, nobody is on ice
  const Fit found = fitted(takes, {"walkSpeed", "climbSpeed", "iceFriction"});
  for (const Fitted& f : found.parameters) {
    EXPECT_EQ(f.known, f.parameter.name == "walkSpeed") << f.parameter.name;
    if (!f.known) {
      EXPECT_EQ(f.value, f.before) << f.parameter.name;
    }
  }
}

// A standing jump's height alone does not tell gravity from launch speed; its time does. Both are
// in the interval when positions are off by a fiftieth of a stud.
TEST(Fit, IntervalsHoldTheTruthUnderNoise) {
  const io::RecordBuilder truth = drawn(4);
  const Fit found = fitted(takesUnder(truth.reader().getParams(), 0.02f, kEnough), kFitted);
  int outside = 0;
  for (const Fitted& f : found.parameters) {
    const double value = valueOf(truth.reader().getParams(), f.parameter.name);
    outside += value < f.low || value > f.high;
    EXPECT_NEAR(f.value, value, 0.05 * value) << f.parameter.name;
  }
  EXPECT_LE(outside, 1) << "of eight intervals of 95 %";
}

}  // namespace
}  // namespace obby::calibrate
