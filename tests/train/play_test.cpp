// Tests the game on which worlds train: the reward of a move, the end of an episode, and the start
// of the next episode.
#include "train/play.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "train/gaps.h"

namespace obby::train {
namespace {

constexpr uint32_t kPlayWorlds = 64;

// A place: worlds at the start of one level.
struct Place {
  explicit Place(bool bodies = false)
      : level(*Gaps(bodies).level(1, 1)),
        view(level->view(3)),
        players(kPlayWorlds),
        bodies(kPlayWorlds * view.level.bodyCount),
        reached(kMaxReached) {
    beginLevel(here());
  }
  PlaceView here() {
    return {&view,   players.data(), bodies.data(),       reached.data(),
            &counts, kPlayWorlds,    view.level.bodyCount};
  }
  void settleAt(uint64_t decision, bool endOfIteration = false, RestartShares shares = {0, 0}) {
    settle(here(), {7, shares, decision, endOfIteration}, 0);
  }

  std::shared_ptr<const TrainingLevel> level;
  TrainingView view;
  std::vector<Player> players;
  std::vector<sim::RigidBody> bodies;
  std::vector<Reached> reached;
  PlaceCounts counts;
};

float leftOf(const Place& place, const Player& p) {
  return place.view.guide.left(p.world.position, 0, 0);
}

TEST(Play, AMoveIsRewardedForGettingNearerThanBefore) {
  Place place;
  const RewardSettings worth;
  Player& p = place.players[0];
  const float whole = p.minLeft;
  EXPECT_EQ(whole, leftOf(place, p));
  p.world.position.z -= 3;
  const float less = leftOf(place, p);
  ASSERT_LT(less, whole - 1);
  EXPECT_FLOAT_EQ(judge(place.view, worth, p).reward, worth.stud * (whole - less) + worth.decision);
  p.world.position.z += 1;
  EXPECT_FLOAT_EQ(judge(place.view, worth, p).reward, worth.decision) << "backwards";
  p.world.position.z -= 2;
  const float minLeft = leftOf(place, p);
  ASSERT_LT(minLeft, less);
  EXPECT_FLOAT_EQ(judge(place.view, worth, p).reward,
                  worth.stud * (less - minLeft) + worth.decision);
  EXPECT_EQ(p.ticks, 3 * policy::kDecisionTicks);
  p.world.outcome = sim::Outcome::goal;
  const Step step = judge(place.view, worth, p);
  EXPECT_TRUE(step.ended);
  EXPECT_FLOAT_EQ(step.reward, worth.goal + worth.decision);
  p.world.outcome = sim::Outcome::fell;
  EXPECT_FLOAT_EQ(judge(place.view, worth, p).reward, worth.death + worth.decision);
}

TEST(Play, EachJumpCostsOnce) {
  Place place;
  RewardSettings worth;
  worth.jump = -0.25f;
  Player& p = place.players[0];
  p.world.jumps = 2;
  EXPECT_FLOAT_EQ(judge(place.view, worth, p).reward, worth.decision + 2 * worth.jump);
  EXPECT_FLOAT_EQ(judge(place.view, worth, p).reward, worth.decision) << "paid already";
  p.world.jumps = 3;
  place.reached[0] = {p.world, p.minLeft};
  place.counts.reached = 1;
  p.world.outcome = sim::Outcome::fell;
  place.settleAt(0, false, {1, 1});
  ASSERT_EQ(p.world.jumps, 3) << "it restarts from a player who had jumped";
  EXPECT_FLOAT_EQ(judge(place.view, worth, p).reward, worth.decision)
      << "the jumps of the other player";
}

TEST(Play, AnEndedEpisodeIsCountedAndRestarted) {
  Place place(true);
  place.players[3].world.outcome = sim::Outcome::goal;
  place.players[5].world.outcome = sim::Outcome::killed;
  place.players[6].world.outcome = sim::Outcome::goal;
  place.players[6].fromStart = false;
  place.players[5].ticks = 30;
  place.bodies[5].position.x = 99;
  place.settleAt(0);
  EXPECT_EQ(place.counts.played, 3u);
  EXPECT_EQ(place.counts.fromStart, 2u);
  EXPECT_EQ(place.counts.solved, 1u);
  EXPECT_EQ(place.players[5].world.outcome, sim::Outcome::running);
  EXPECT_EQ(place.players[5].ticks, 0u);
  EXPECT_TRUE(place.players[6].fromStart);
  EXPECT_EQ(place.bodies[5].position.x, place.view.startBodies[0].position.x);
}

TEST(Play, ALongEpisodeIsTruncatedAtTheEndOfAnIteration) {
  Place place;
  place.players[2].ticks = place.view.maxTicks;
  place.players[4].ticks = place.view.maxTicks - 1;
  place.settleAt(0);
  EXPECT_EQ(place.counts.played, 0u);
  place.settleAt(1, true);
  EXPECT_EQ(place.counts.played, 1u);
  EXPECT_EQ(place.counts.solved, 0u);
  EXPECT_EQ(place.players[2].ticks, 0u);
  EXPECT_EQ(place.players[4].ticks, place.view.maxTicks - 1);
}

TEST(Play, EpisodesRestartWhereOthersStood) {
  Place place;
  for (Player& p : place.players) {
    p.world.position.z = -5;
    p.world.floorlessSteps = 1;
  }
  for (uint64_t d = 0; d < 100; ++d) place.settleAt(d);
  EXPECT_EQ(place.counts.reached, 0u) << "in the air";
  for (Player& p : place.players) {
    p.world.floorlessSteps = 0;
    p.minLeft = 7;
  }
  place.settleAt(100);
  EXPECT_LT(place.counts.reached, 8u) << "one in 64";
  for (uint64_t d = 101; d < 150; ++d) place.settleAt(d);
  EXPECT_EQ(place.counts.reached, kMaxReached);
  for (Player& p : place.players) p.world.outcome = sim::Outcome::fell;
  place.settleAt(150, false, {0.5f, 0.5f});
  int elsewhere = 0;
  for (const Player& p : place.players) {
    elsewhere += !p.fromStart;
    EXPECT_EQ(p.world.position.z, p.fromStart ? place.view.start.position.z : -5);
    EXPECT_EQ(p.minLeft, p.fromStart ? leftOf(place, p) : 7);
  }
  EXPECT_GT(elsewhere, 16);
  EXPECT_LT(elsewhere, 48);
}

TEST(Play, ASolvedLevelHasItsOwnShareOfRestarts) {
  Place place;
  const RestartShares onlyUnsolved{1, 0};
  place.reached[0] = {place.view.start, 5};
  place.counts.reached = 1;
  const auto allEnd = [&](sim::Outcome outcome, bool fromStart) {
    for (Player& p : place.players) {
      p.world.outcome = outcome;
      p.fromStart = fromStart;
    }
  };
  const auto elsewhere = [&] {
    return std::count_if(place.players.begin(), place.players.end(),
                         [](const Player& p) { return !p.fromStart; });
  };
  allEnd(sim::Outcome::fell, true);
  place.settleAt(0, false, onlyUnsolved);
  EXPECT_EQ(elsewhere(), kPlayWorlds);
  allEnd(sim::Outcome::goal, false);
  place.settleAt(1, false, onlyUnsolved);
  EXPECT_EQ(place.counts.solvedOnce, 0u) << "not from the start of the level";
  EXPECT_EQ(elsewhere(), kPlayWorlds);
  allEnd(sim::Outcome::goal, true);
  place.settleAt(2, false, onlyUnsolved);
  EXPECT_EQ(place.counts.solvedOnce, 1u);
  EXPECT_EQ(elsewhere(), 0);
  beginLevel(place.here());
  EXPECT_EQ(place.counts.solvedOnce, 0u) << "another level";
}

// The guide doubles back. Its later lane is near, but does not count yet.
TEST(Play, ARestartKeepsTheDistanceThatWasLeft) {
  const Guide guide({{0, 0, 0}, {-60, 0, 0}, {70, 0, 0}});
  Place place;
  place.view.guide = guide.view();
  beginLevel(place.here());
  for (Player& p : place.players) p.world.floorlessSteps = 1;
  Player &there = place.players[0], &other = place.players[1];
  there.world.floorlessSteps = 0;
  there.world.position = {-10, 0, 0};
  const RewardSettings worth;
  judge(place.view, worth, there);
  ASSERT_FLOAT_EQ(there.minLeft, 180);
  for (uint64_t d = 0; place.counts.reached == 0; ++d) {
    ASSERT_LT(d, 10000u);
    place.settleAt(d);
  }
  other.world.outcome = sim::Outcome::fell;
  place.settleAt(10000, false, {1, 1});
  ASSERT_FALSE(other.fromStart);
  EXPECT_EQ(other.world.position.x, -10);
  EXPECT_FLOAT_EQ(other.minLeft, 180);
  EXPECT_FLOAT_EQ(judge(place.view, worth, other).reward, worth.decision) << "no progress yet";
}

TEST(Play, RandomNumbersDependOnTheWorldAndItsDecision) {
  const auto draw = [](Draw use, uint64_t decision, uint32_t world) {
    return drawsOf(3, use, decision, world).next();
  };
  EXPECT_EQ(draw(Draw::move, 5, 6), draw(Draw::move, 5, 6));
  EXPECT_NE(draw(Draw::move, 5, 6), draw(Draw::move, 5, 7));
  EXPECT_NE(draw(Draw::move, 5, 6), draw(Draw::move, 6, 5));
  EXPECT_NE(draw(Draw::move, 5, 6), draw(Draw::begin, 5, 6));
}

}  // namespace
}  // namespace obby::train
