// Jumps that move a player at once: what they may gain, and that no time limit is called too low
// for that.
#include "solve/proof/put_out.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenes.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {
namespace {

std::vector<PutOut> putOutsIn(const level::Level& level) {
  const Problem problem = support::plainProblem(level, {});
  return ReachBound(problem, true).putOuts();
}

float farthestOf(const std::vector<PutOut>& outs) {
  float farthest = 0;
  for (const PutOut& out : outs) farthest = std::max(farthest, out.studs);
  return farthest;
}

// Runs from `behind` the start along -Z, jumps at `jumpAt`: the studs that a tick gains at most.
float mostGained(const level::Level& level, float behind, uint32_t jumpAt) {
  const Problem problem = support::plainProblem(level, {});
  const float usual = level.view().params.walkSpeed * level.view().params.tickSeconds;
  sim::World w = problem.start;
  w.position.z += behind;
  float most = 0;
  for (uint32_t t = 0; t < 60; ++t) {
    const float before = w.position.z;
    sim::advance(w, nullptr, level.view(), nullptr, {0, true, t == jumpAt});
    most = std::max(most, before - w.position.z - usual);
  }
  return most;
}

TEST(PutOut, AJumpIntoAThinFenceEndsBeforeIt) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {60, 1, 120}).spawn({0, 0, 0});
  b.block({0, 2.2f, -12}, {60, 4.4f, 0.05f});
  b.physics([](schema::PhysicsParams::Builder p) { p.setWalkSpeed(24); });
  const level::Level level = b.compile();
  float gained = 0;
  for (uint32_t jumpAt = 26; jumpAt < 42; ++jumpAt) {
    for (int i = 0; i < 20; ++i) {
      gained = std::max(gained, mostGained(level, 0.02f * float(i), jumpAt));
    }
  }
  EXPECT_GT(gained, 0.2f) << "nobody was put out on the far side";
  EXPECT_GE(farthestOf(putOutsIn(level)), gained);
}

// The studs that the bound grants on 28 studs straight ahead from the start.
float grantedAhead(const level::Level& level) {
  const Problem problem = support::plainProblem(level, {});
  const Box from{problem.start.position, problem.start.position}, to{{-4, 0, -32}, {4, 4, -28}};
  return gapBetween(from, to) - ReachBound(problem, true).wayPast(from, {}, to);
}

// A fence that the torso of who jumps over it is in when it falls past its far edge.
TEST(PutOut, AFarEdgePutsOutForwardWhoFallsPastIt) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {60, 1, 120}).spawn({0, 0, 0});
  EXPECT_FLOAT_EQ(grantedAhead(b.compile()), 0) << "all of the way is on one floor";
  // A substep before the feet are below 3.985 studs they are at 4.13: the torso is in it by 0.135.
  b.block({0, 3.06f, -12}, {60, 6.12f, 0.05f});
  const level::Level level = b.compile();
  float gained = 0;
  for (uint32_t jumpAt = 16; jumpAt < 30; ++jumpAt) {
    for (int i = 0; i < 28; ++i) {
      gained = std::max(gained, mostGained(level, 0.01f * float(i), jumpAt));
    }
  }
  EXPECT_GT(gained, 0.02f) << "nobody was put out";
  EXPECT_GE(grantedAhead(level), gained);
}

// Whoever passes those has come farther than they put anybody out.
TEST(PutOut, WhatIsFarFromTheWayGrantsNothing) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {300, 1, 120}).spawn({0, 0, 0});
  for (int i = 0; i < 100; ++i) b.block({120, 3, -0.4f * float(i)}, {40, 6, 0.05f});
  EXPECT_FLOAT_EQ(grantedAhead(b.compile()), 0);
}

// A wall of 22 studs, so wide, across the way to 28 studs ahead.
float grantedBehindWall(float width) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {60, 1, 120}).spawn({0, 0, 0});
  b.block({0, 10, -14}, {width, 22, 4});
  return grantedAhead(b.compile());
}

TEST(PutOut, AWallThatTakesTimeToGoAroundGrantsNothing) {
  EXPECT_FLOAT_EQ(grantedBehindWall(24), 0);
  EXPECT_GT(grantedBehindWall(1), 0.1f) << "hardly any time";
}

TEST(PutOut, NothingIsGainedOnStonesWithGaps) {
  EXPECT_TRUE(putOutsIn(steppingStones().compile()).empty());
}

// What a row of walls is flush with leads on through all of them.
TEST(PutOut, ThinWallsBesideALowBlockLeadOnWithoutABound) {
  LevelBuilder b;
  b.block({0, -0.5f, 0}, {60, 1, 120}).spawn({0, 0, 0});
  b.block({0, 2, -12}, {8, 4, 4});
  EXPECT_FALSE(std::isinf(farthestOf(putOutsIn(b.compile()))));
  b.block({0, 20, -14.5f}, {40, 40, 1});
  EXPECT_TRUE(std::isinf(farthestOf(putOutsIn(b.compile()))));
}

// 156 studs along a floor, with fences across it.
uint32_t saidOfFences(float top, const std::string& limits, const std::string& more = {}) {
  std::string text = R"({"type":"level","name":"fences","parts":[)"
                     R"({"name":"Floor","position":[0,-0.5,-90],"size":[40,1,200]})";
  for (int i = 0; i < 18; ++i) {
    text += fmt::format(R"(,{{"name":"Fence","position":[0,{},{}],"size":[40,{},0.05]}})",
                        0.5 * double(top), -8 - 8 * i, top);
  }
  text += more + R"(],"spawns":[{"position":[0,0,0]}]})" + "\n";
  text +=
      R"({"type":"query","id":"q","goal":{"position":[0,2,-160],"size":[8,4,8]},)" + limits + "}\n";
  const LinesFile file(text);
  FilterOptions o;
  o.solver.budget.maxSteps = 20'000;
  o.solver.progressRecords = false;
  const Filtered f = runFilter(file.path(), std::move(o));
  EXPECT_TRUE(f.status) << f.status.error().text();
  return uint32_t(f.counts.unreachable);
}

// At 16 studs/s they take 9.75 s; of each half a stud may be had for nothing, at its far edge.
TEST(PutOut, ALimitALittleTooLowMayBeKeptThroughFences) {
  const std::string little = R"("timeLimit":9.6)", less = R"("timeLimit":9)";
  EXPECT_EQ(saidOfFences(4.4f, less), 0u);
  EXPECT_EQ(saidOfFences(4.4f, R"("timeLimit":5)"), 1u) << "too far for that";
  EXPECT_EQ(saidOfFences(4.4f, less + R"(,"maxJumps":0)"), 1u) << "by jumps only";
  EXPECT_EQ(saidOfFences(0.3f, less), 1u) << "below the torso";
  EXPECT_EQ(saidOfFences(14, less), 1u) << "as high as the head";
  EXPECT_EQ(saidOfFences(0.3f, little), 0u) << "but fallen past";
  EXPECT_EQ(saidOfFences(8.5f, little), 0u) << "jumped over, and fallen past";
}

// The legs of who trips on the way are put out of what is there.
TEST(PutOut, NothingIsSaidOfTimeWhereSomebodyMayFallDown) {
  const char* trip =
      R"(,{"name":"Trip","position":[0,1,-20],"size":[2,2,2],"solid":false,"trip":{}})";
  EXPECT_EQ(saidOfFences(0.3f, R"("timeLimit":9)", trip), 0u);
}

TEST(PutOut, CountsFromWhereItCanBegin) {
  EXPECT_FLOAT_EQ(secondsFor(160, 16, {}, -1), 10);
  // From 80 studs on twice as fast; the last two are for nothing.
  EXPECT_FLOAT_EQ(secondsFor(160, 16, {{80, 2, 0.125f}}, -1), 5 + 78 / 32.0f);
  EXPECT_FLOAT_EQ(secondsFor(160, 16, {{80, 2, 0.125f}}, 1), 158 / 16.0f);
  EXPECT_FLOAT_EQ(secondsFor(160, 16, {{200, 2, 0.125f}}, -1), 10);
}

}  // namespace
}  // namespace obby::solve
