// Recordings against what the simulator makes of their inputs.
#include "calibrate/fidelity.h"

#include <gtest/gtest.h>

#include "calibrate/course.h"

namespace obby::calibrate {
namespace {

io::RecordBuilder paramsWith(const std::string& name, double value) {
  io::RecordBuilder out;
  setValue(out.root().initParams(), name, value);
  return out;
}

std::vector<Take> jumps(schema::PhysicsParams::Reader params) {
  return takesUnder(params, 0, manoeuvresNamed({"jump on the spot"}));
}

TEST(Fidelity, OfOwnRecordingsIsExact) {
  for (const Take& take : takesUnder(defaults())) {
    const auto f = fidelityOf(take, defaults());
    ASSERT_TRUE(f) << f.error().text();
    EXPECT_LT(f->max, 1e-3) << take.track.name;
    EXPECT_EQ(f->matched, f->events) << take.track.name;
    EXPECT_EQ(f->frames + 1, take.track.frames.size());
  }
}

TEST(Fidelity, TellsTheApexUnderOtherGravity) {
  const io::RecordBuilder weak = paramsWith("gravity", 180);
  const std::vector<Take> takes = jumps(weak.reader().getParams());
  ASSERT_EQ(takes.size(), 1u);
  const auto f = fidelityOf(takes[0], defaults());
  ASSERT_TRUE(f);
  ASSERT_TRUE(f->apex);
  EXPECT_NEAR(*f->apex, 53 * 53 / 2.0 * (1 / 180.0 - 1 / 196.2), 0.05);
  EXPECT_GT(f->max, *f->apex);
}

TEST(Fidelity, CountsEventsThatTheSimulatorMisses) {
  std::vector<Take> takes = jumps(defaults());
  ASSERT_EQ(takes.size(), 1u);
  const auto whole = fidelityOf(takes[0], defaults());
  for (Frame& frame : takes[0].track.frames) frame.jump = false;
  const auto without = fidelityOf(takes[0], defaults());
  ASSERT_TRUE(whole && without);
  EXPECT_EQ(without->events, whole->events);
  EXPECT_LT(without->matched, whole->matched);
}

TEST(Fidelity, PlaysFramesThatAreNoWholeStepsByTheLevelsTicks) {
  std::vector<Take> takes = jumps(defaults());
  ASSERT_EQ(takes.size(), 1u);
  auto& frames = takes[0].track.frames;
  for (size_t i = 1; i < frames.size(); i += 2) frames[i].time += 0.0014;  // a third of a step
  const auto f = fidelityOf(takes[0], defaults());
  ASSERT_TRUE(f) << f.error().text();
  EXPECT_LT(f->mean, 0.1);
  EXPECT_GT(f->mean, 0.001) << "positions are compared at the shifted times";
}

TEST(Fidelity, SummaryHasTheMedianAndTheWorstTwentieth) {
  std::vector<Fidelity> all(21);
  for (size_t i = 0; i < all.size(); ++i) {
    all[i].mean = double(20 - i);
    all[i].events = 2;
    all[i].matched = 1;
  }
  all[3].apex = 0.5;
  const FidelitySummary s = summaryOf(all);
  EXPECT_DOUBLE_EQ(s.medianMean, 10);
  EXPECT_DOUBLE_EQ(s.p95Mean, 19);
  EXPECT_DOUBLE_EQ(*s.matched, 0.5);
  EXPECT_DOUBLE_EQ(*s.medianApex, 0.5);
}

}  // namespace
}  // namespace obby::calibrate
