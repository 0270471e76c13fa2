// A fit recovers the parameters of a recording, and reports those that it cannot determine.
#include "calibrate/fit.h"

#include <gtest/gtest.h>

#include <span>

#include "base/random.h"

#include "calibrate/course.h"
#include "support/recording_faults.h"

namespace obby::calibrate {
namespace {

const std::vector<std::string> kFitted = {"walkSpeed", "traction",  "airAccel",       "gravity",
                                          "jumpSpeed", "hipHeight", "playerFriction", "climbSpeed"};

// Returns manoeuvres that together determine all parameters of this test.
std::vector<Manoeuvre> enough() {
  return manoeuvresNamed({"run, stop, turn", "jump on the spot", "jump and turn back in the air",
                          "hold jump", "run and stop on ice", "climb up and down"});
}

// Returns the manoeuvres that determine gravity and the speed of a jump.
std::vector<Manoeuvre> jumps() {
  return manoeuvresNamed({"jump on the spot", "jump and turn back in the air", "hold jump"});
}

// Numbers of generations of a search, for at most kFew parameters and for more. A refinement
// follows.
constexpr size_t kFew = 3;
constexpr uint32_t kForFew = 20, kForMany = 60;

// Returns parameters that are drawn within a share of their defaults.
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

Fit fitted(const std::vector<Take>& takes, const std::vector<std::string>& names,
           std::span<const Take> heldOut = {}) {
  ThreadPool pool(availableThreads());
  const std::atomic<bool> stop{false};
  FitSettings settings;
  settings.restarts = 1;
  settings.generations = names.size() <= kFew ? kForFew : kForMany;
  settings.tolerance = 0.05;
  settings.heldOut = heldOut;
  auto out = fit(takes, *parametersNamed(names, defaults()), defaults(), settings, pool, stop,
                 [](const FitProgress&) {});
  EXPECT_TRUE(out) << out.error().text();
  return *std::move(out);
}

class Drawn : public testing::TestWithParam<uint64_t> {};

TEST_P(Drawn, ParametersAreFoundAgain) {
  const io::RecordBuilder truth = drawn(GetParam());
  const Fit found = fitted(takesUnder(truth.reader().getParams(), 0, enough()), kFitted);
  EXPECT_LT(found.loss, 1e-4 * found.lossBefore);
  for (const Fitted& f : found.parameters) {
    const double value = valueOf(truth.reader().getParams(), f.parameter.name);
    EXPECT_NEAR(f.value, value, 0.01 * value) << f.parameter.name;
    EXPECT_TRUE(f.known) << f.parameter.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, Drawn, testing::Values(1, 2));

TEST(Fit, ReportsUndeterminedParameters) {
  io::RecordBuilder truth;
  setValue(truth.root().initParams(), "walkSpeed", 18);
  std::vector<Take> takes = takesUnder(truth.reader().getParams());
  takes.erase(takes.begin() + 2, takes.end());  // removes the climb and the contact with a wall
  const Fit found = fitted(takes, {"walkSpeed", "climbSpeed", "bodyWidth"});
  for (const Fitted& f : found.parameters) {
    EXPECT_EQ(f.known, f.parameter.name == "walkSpeed") << f.parameter.name;
    if (!f.known) {
      EXPECT_EQ(f.value, f.before) << f.parameter.name;
    }
  }
}

// A place that states its own walk speed keeps it. Its recordings reveal nothing about the game's
// walk speed.
TEST(Fit, KeepsParametersThatTheLevelStates) {
  io::RecordBuilder truth;
  setValue(truth.root().initParams(), "walkSpeed", 24);
  setValue(truth.root().getParams(), "gravity", 180);
  std::vector<Take> takes = takesUnder(truth.reader().getParams(), 0, firstManoeuvres(3));
  io::RecordBuilder fast(takes[0].level.reader());
  fast.root().getLevel().getPhysics().setWalkSpeed(24);
  const io::Record level(std::move(fast));
  for (Take& take : takes) take.level = level;
  const Fit found = fitted(takes, {"walkSpeed", "gravity"});
  EXPECT_EQ(found.parameters[0].value, 16);
  EXPECT_FALSE(found.parameters[0].known);
  EXPECT_NEAR(found.parameters[1].value, 180, 0.5);
  EXPECT_LT(found.loss, 1e-6);
}

// The height of a standing jump does not separate gravity from jump speed, but its duration does.
// With positions off by 1/50 stud, both intervals contain the truth.
TEST(Fit, IntervalsHoldTheTruthUnderNoise) {
  const io::RecordBuilder truth = drawn(4);
  const Fit found =
      fitted(takesUnder(truth.reader().getParams(), 0.02f, firstManoeuvres(9)), kFitted);
  int outside = 0;
  for (const Fitted& f : found.parameters) {
    const double value = valueOf(truth.reader().getParams(), f.parameter.name);
    outside += value < f.low || value > f.high;
    const bool shared = f.parameter.name == "traction" || f.parameter.name == "playerFriction";
    EXPECT_NEAR(f.value, value, (shared ? 0.05 : 0.002) * value) << f.parameter.name;
  }
  // The legs push the feet only from below their rest height, so noise causes a bias of 0.1 %.
  EXPECT_LE(outside, 3) << "of eight intervals of 95 %";
  EXPECT_EQ(found.controlRate, 60u);
  EXPECT_EQ(found.substeps, 4u);
}

// The recorder drops frames, records at uneven times, adds noise, and rounds inputs to sixteen
// directions. The effect of an input shows two frames late.
TEST(Fit, CopesWithABadRecorder) {
  const io::RecordBuilder truth = drawn(5);
  std::vector<Take> takes = takesUnder(truth.reader().getParams(), 0, firstManoeuvres(4));
  const test::Faults faults{
      .noise = 0.01f, .dropped = 0.1f, .jitter = 0.004, .late = 2, .directions = 16};
  for (Take& take : takes) take.track = test::spoiled(take.track, faults, take.track.frames.size());
  const Fit found =
      fitted(takes, {"walkSpeed", "traction", "airAccel", "gravity", "jumpSpeed", "hipHeight"});
  EXPECT_NEAR(found.delay, 2 / 60.0, 0.75 / 60);
  for (const Fitted& f : found.parameters) {
    const double value = valueOf(truth.reader().getParams(), f.parameter.name);
    // A player reaches full speed within six steps (less than two frames), so traction is less
    // certain.
    const double share = f.parameter.name == "traction" ? 0.08 : 0.03;
    EXPECT_NEAR(f.value, value, share * value) << f.parameter.name;
  }
}

// An engine may integrate with the velocity at a step's end. Its recorded velocities are then half
// a step older than the positions, here a quarter of a frame. Gravity and jump speed must not
// absorb this error.
TEST(Fit, CorrectsForOldVelocities) {
  io::RecordBuilder truth;
  setValue(truth.root().initParams(), "gravity", 180);
  setValue(truth.root().getParams(), "jumpSpeed", 48);
  std::vector<Take> takes = takesUnder(truth.reader().getParams(), 0.01f, jumps());
  for (Take& take : takes) take.track = test::withLateVelocities(take.track, 0.25f);
  const Fit found = fitted(takes, {"gravity", "jumpSpeed"});
  EXPECT_NEAR(found.parameters[0].value, 180, 0.9);
  EXPECT_NEAR(found.parameters[1].value, 48, 0.24);
}

// With rules in each step, jumps end between frames, and a held jump repeats at once.
TEST(Fit, FindsThatTheRulesRunInEachStep) {
  io::RecordBuilder truth;
  setValue(truth.root().initParams(), "gravity", 185);
  setValue(truth.root().getParams(), "controlRate", 240);
  setValue(truth.root().getParams(), "substeps", 1);
  const Fit found =
      fitted(takesUnder(truth.reader().getParams(), 0.01f, jumps()), {"gravity", "jumpSpeed"});
  EXPECT_EQ(found.controlRate, 240u);
  EXPECT_EQ(found.substeps, 1u);
  EXPECT_NEAR(found.parameters[0].value, 185, 0.2);
}

// At that rate, a step of a level with its own rate would last a whole tick, so the level does not
// compile.
TEST(Fit, ContinuesIfALevelDoesNotCompileWithRulesInEachStep) {
  std::vector<Take> takes = takesUnder(
      defaults(), 0, manoeuvresNamed({"jump on the spot", "jump and turn back in the air"}));
  io::RecordBuilder slow(takes[0].level.reader());
  slow.root().getLevel().getPhysics().setControlRate(50);
  const io::Record level(std::move(slow));
  for (Take& take : takes) take.level = level;
  const Fit found = fitted(takes, {"gravity"});
  EXPECT_EQ(found.controlRate, 60u);
  EXPECT_EQ(found.substeps, 4u);
}

// The recording's level states its own physics and does not compile with the result.
TEST(Fit, ContinuesIfAHeldOutLevelDoesNotCompile) {
  const std::vector<Take> takes = takesUnder(defaults(), 0, manoeuvresNamed({"jump on the spot"}));
  io::RecordBuilder slow(takes[0].level.reader());
  slow.root().getLevel().getPhysics().setControlRate(50);
  slow.root().getLevel().getPhysics().setSubsteps(1);
  const std::vector<Take> heldOut = {{takes[0].track, io::Record(std::move(slow))}};
  ASSERT_FALSE(levelWith(heldOut[0], defaults()));
  const Fit found = fitted(takes, {"gravity"}, heldOut);
  EXPECT_NEAR(found.parameters[0].value, 196.2, 0.2);
}

// By default the acceleration is zero, which has no logarithm.
TEST(Fit, FindsTheEffectOfKeysWhileJumping) {
  const auto played = manoeuvresNamed({"jump and turn back in the air", "hold jump"});
  for (const double accel : {0.0, 110.0}) {
    io::RecordBuilder truth;
    setValue(truth.root().initParams(), "jumpAccel", accel);
    setValue(truth.root().getParams(), "walkSpeed", 18);
    const Fit found =
        fitted(takesUnder(truth.reader().getParams(), 0.01f, played), {"walkSpeed", "jumpAccel"});
    EXPECT_NEAR(found.parameters[1].value, accel, 5);
    EXPECT_TRUE(found.parameters[1].known);
  }
}

TEST(Parameters, AreClampedToTheirBounds) {
  for (const Parameter& p : parametersAround(defaults())) {
    EXPECT_EQ(shareOf(p, 0), 0) << p.name;
    EXPECT_EQ(shareOf(p, 2 * p.highest), 1) << p.name;
  }
}

TEST(Parameters, DuplicateNamesAreFittedOnce) {
  const auto named = parametersNamed({"gravity", "walkSpeed", "gravity"}, defaults());
  ASSERT_TRUE(named);
  ASSERT_EQ(named->size(), 2u);
  EXPECT_EQ((*named)[0].name, "gravity");
  EXPECT_EQ((*named)[1].name, "walkSpeed");
}

TEST(Parameters, AreTriedWithinTheSchemasRanges) {
  for (const Parameter& p : parametersAround(defaults())) {
    for (const double value : {p.lowest, p.highest}) {
      io::RecordBuilder params;
      EXPECT_TRUE(setNamed(params.root().initParams(), p.name, value)) << p.name << " " << value;
    }
  }
}

}  // namespace
}  // namespace obby::calibrate
