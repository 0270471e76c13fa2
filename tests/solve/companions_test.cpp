// Companions are other players who press the same keys. A state counts only if all of them follow.
#include "solve/search/rollouts/companions.h"

#include <gtest/gtest.h>

#include "level/player.h"
#include "scenes.h"
#include "solve/search/rollouts/explore_setup.h"

namespace obby::solve {
namespace {

// Returns the level compiled for players at this frame rate, in frames per second.
level::Level atRate(LevelBuilder b, uint16_t rate) {
  io::RecordBuilder record;
  record.root().setLevel(b.record());
  EXPECT_TRUE(level::setPlayer({"", rate}, record.root().getLevel()));
  return *level::Level::compile(record.reader().getLevel());
}

LevelBuilder twoStones(bool second) {
  LevelBuilder b;
  b.block({0, -0.5f, -4}, {8, 1, 8});
  if (second) b.block({0, -0.5f, -16}, {8, 1, 8});
  b.spawn({0, 0, -2});
  b.physics([](schema::PhysicsParams::Builder p) { p.setFallenPartsHeight(-40); });
  return b;
}

// Returns a run-up and a jump across the gap of 4 studs, at 30 frames a second.
ActionRuns jumpAcross() {
  const sim::Action walk{0, true, false}, jump{0, true, true}, rest{};
  return {{walk, 9}, {jump, 1}, {walk, 16}, {rest, 30}};
}

struct Pair {
  explicit Pair(bool second)
      : own(atRate(twoStones(true), 30)), other(atRate(twoStones(second), 240)), asked(own) {
    asked.query.goal = boxAt({0, 200, 0}, {1, 1, 1});
    problem = asked.problem();
    problem.known = {jumpAcross()};
    problem.companions.push_back({other.view(), asked.query, sim::makeWorld(other.view(), start()),
                                  sim::startBodies(other.view())});
  }
  static level::StartPose start() { return {{0, 0, -2}, 0, 0}; }

  level::Level own, other;
  PlainQuery asked;
  Problem problem;
};

TEST(Companions, ComeAlongIfTheSameKeysDo) {
  const Pair pair(true);
  const ExploreSetup setup(pair.problem, 1, {});
  const Companions all(pair.problem, setup.rules.context, 1);
  Companions::Walk walk(all, 0, kWarmStart);
  EXPECT_TRUE(walk.follow(9));
  EXPECT_TRUE(walk.follow(50)) << "both stand on the second stone";
}

TEST(Companions, AFallenCompanionIsNotThere) {
  const Pair pair(false);
  const ExploreSetup setup(pair.problem, 1, {});
  const Companions all(pair.problem, setup.rules.context, 1);
  Companions::Walk walk(all, 0, kWarmStart);
  EXPECT_TRUE(walk.follow(9));
  EXPECT_FALSE(walk.follow(50));
}

TEST(Companions, ContinueFromAKeptWalk) {
  const Pair pair(true);
  const ExploreSetup setup(pair.problem, 1, {});
  Companions all(pair.problem, setup.rules.context, 1);
  Companions::Walk first(all, 0, kWarmStart);
  ASSERT_TRUE(first.follow(50));
  all.keep(1, first);
  Companions::Walk second(all, 1, kWarmStart);
  EXPECT_TRUE(second.follow(5));
  EXPECT_EQ(second.player().tick, 55u);
  EXPECT_LT(second.player().position.z, first.player().position.z - 1);
}

}  // namespace
}  // namespace obby::solve
