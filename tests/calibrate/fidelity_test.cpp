// Compares recordings with the simulator's play of the same inputs.
#include "calibrate/fidelity.h"

#include <gtest/gtest.h>

#include "calibrate/course.h"
#include "calibrate/trick_evidence.h"
#include "level/tricks.h"
#include "sim/simulator.h"

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

TEST(Fidelity, IsExactForSimulatedRecordings) {
  for (const Take& take : takesUnder(defaults())) {
    const auto f = fidelityOf(take, defaults());
    ASSERT_TRUE(f) << f.error().text();
    EXPECT_LT(f->max, 1e-3) << take.track.name;
    EXPECT_EQ(f->matched, f->events) << take.track.name;
    EXPECT_EQ(f->frames + 1, take.track.frames.size());
  }
}

// Returns a recording of a jump with a right-angle turn, in an engine with these tricks.
Take turningJump(uint16_t tricks) {
  io::RecordBuilder record;
  writeCourse(record.root().initLevel());
  const io::Record course(std::move(record));
  const auto level = level::Level::compile(course.reader().getLevel());
  level::LevelView view = level->view();
  view.params.tricks = tricks;
  sim::World w = sim::makeWorld(view, level->spawns()[0]);
  auto bodies = sim::startBodies(view);
  Take take{{"jump", course.reader().getLevel().getName()}, course};
  for (int tick = 0; tick < 120; ++tick) {
    const sim::Action action{Turns(0x4000), tick >= 60, tick == 60};
    if (tick >= 50) {
      const Vec3 move = action.walk ? directionOf(sinCosOf<float>(action.heading)) : Vec3{};
      take.track.frames.push_back({(tick - 50) / 60.0, move, action.jump,
                                   rootOf(w.position, view.params), w.velocity, w.state,
                                   directionOf(sinCosOf<float>(w.yaw))});
    }
    sim::advance(w, bodies.data(), view, nullptr, action);
  }
  return take;
}

// The engine that recorded the jumps allows the trick of held jumps.
TEST(TrickEvidence, FindsTheTrickThatTheEngineHas) {
  ThreadPool pool(availableThreads());
  std::vector<Take> takes;
  for (int i = 0; i < 4; ++i) takes.push_back(turningJump(kHeldJump));
  const auto held = trickEvidence(takes, defaults(), pool);
  ASSERT_TRUE(held);
  for (const TrickEvidence& e : *held) {
    EXPECT_EQ(e.isOn(), e.trick == schema::Trick::HELD_JUMP) << level::trickName(e.trick);
  }
  EXPECT_LT((*held)[0].with, 0.01);
  const auto none = trickEvidence(takesUnder(defaults()), defaults(), pool);
  ASSERT_TRUE(none);
  EXPECT_EQ(textOf(*none), "");
}

TEST(Fidelity, MeasuresTheApexUnderOtherGravity) {
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

TEST(Fidelity, PlaysFramesOfFractionalStepsInTheLevelsTicks) {
  std::vector<Take> takes = jumps(defaults());
  ASSERT_EQ(takes.size(), 1u);
  auto& frames = takes[0].track.frames;
  for (size_t i = 1; i < frames.size(); i += 2)
    frames[i].time += 0.0014;  // moves the frame by a third of a step
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
