// Searches with the methods `pbge` and `cflge`: kept trajectories replay, the methods learn, and
// results depend only on the problem and the seed.
#include <gtest/gtest.h>

#include "baselines/cflge.h"
#include "baselines/pbge.h"
#include "solve/methods.h"
#include "solve/scenes.h"

namespace obby::baselines {
namespace {

// Returns a corridor six studs wide and 124 long, in empty space. The goal is out of reach.
level::Level learnedSearchCorridor() {
  LevelBuilder b;
  b.block({0, -0.5f, -60}, {6, 1, 124});
  b.spawn({0, 0, -2});
  b.physics([](schema::PhysicsParams::Builder p) { p.setFallenPartsHeight(-40); });
  return b.compile();
}

// Returns the share of successful returns in the rounds from `first` to `last`.
template <class S>
double returnRate(S& search, int first, int last) {
  for (int r = 0; r < first; ++r) search.round();
  const Returns before = search.returns();
  for (int r = first; r < last; ++r) search.round();
  const Returns after = search.returns();
  EXPECT_GT(after.tried - before.tried, 50u);
  return double(after.reached - before.reached) / double(after.tried - before.tried);
}

template <class S>
void expectKeptTrajectoriesToReplay(S& search) {
  const Archive& archive = search.archive();
  ASSERT_GT(archive.cellCount(), 200u);
  for (uint32_t c = 0; c < archive.cellCount(); ++c) {
    const Trajectory p = search.trajectoryTo(archive.nodes()[archive.node(c)]);
    const auto bodies = archive.bodies(c);
    ASSERT_EQ(sim::stateHash(p.end, p.endBodies), sim::stateHash(archive.world(c), bodies)) << c;
  }
  const Closest& closest = search.statistics().closest;
  const Trajectory p = search.trajectoryTo(closest.node);
  EXPECT_EQ(p.end.position.x, closest.position.x);
  EXPECT_EQ(p.end.position.z, closest.position.z);
}

template <class S>
void expectTruthfulStatistics(S& search, uint64_t rollouts) {
  uint64_t ends = 0;
  for (const EndCount& e : search.attempts().counts()) ends += e.count;
  EXPECT_EQ(ends, search.statistics().rollouts);
  EXPECT_GT(search.statistics().rollouts, rollouts);
  EXPECT_LE(search.singletons(), search.cellCount());
  for (const AttemptEnd& e : search.attempts().sample(20, {})) {
    EXPECT_EQ(search.trajectoryTo(e.node).end.outcome, e.outcome);
  }
}

TEST(Pbge, KeepsTrajectoriesThatReplayAndCountsItsWork) {
  const level::Level level = learnedSearchCorridor();
  const Problem problem = support::endlessProblem(level);
  ThreadPool pool(2);
  Pbge search(problem, 1, {}, {pool});
  for (int r = 0; r < 20; ++r) search.round();
  expectKeptTrajectoriesToReplay(search);
  expectTruthfulStatistics(search, 50);
  EXPECT_EQ(search.statistics().rounds, 20u);
  EXPECT_GT(search.statistics().steps, 20u * 32 * 32 * 2);
  EXPECT_LE(search.statistics().steps, 20u * 32 * 32 * policy::kDecisionTicks);
}

TEST(Cflge, KeepsTrajectoriesThatReplayAndCountsItsWork) {
  const level::Level level = learnedSearchCorridor();
  const Problem problem = support::endlessProblem(level);
  ThreadPool pool(2);
  Cflge search(problem, 1, {}, {pool});
  for (int r = 0; r < 20; ++r) search.round();
  expectKeptTrajectoriesToReplay(search);
  expectTruthfulStatistics(search, 50);
}

// The player cannot stand in cells that are only reached in flight, so they cannot be goals.
TEST(LearnedSearches, KeepCellsInWhichThePlayerStands) {
  const level::Level stones = steppingStones().compile();
  PlainQuery asked(stones);
  ThreadPool pool(2);
  Pbge search(asked.problem(), 1, {}, {pool});
  for (int r = 0; r < 30; ++r) search.round();
  ASSERT_GT(search.cellCount(), 20u);
  for (uint32_t c = 1; c < search.cellCount(); ++c)
    EXPECT_TRUE(grounded(search.archive().world(c))) << c;
}

// Expects that forgetting frees memory and changes nothing that is still needed.
template <class S, class Settings>
void expectForgettingToShowNowhere(const Problem& problem) {
  ThreadPool pool(2);
  Settings forgetful;
  forgetful.forgetFrom = 1;
  S keeps(problem, 1, Settings{}, {pool}), forgets(problem, 1, forgetful, {pool});
  for (int r = 0; r < 60; ++r) {
    keeps.round();
    forgets.round();
  }
  EXPECT_LT(forgets.bytesKept(), keeps.bytesKept());
  EXPECT_TRUE(forgets.places(0) == keeps.places(0));
  expectKeptTrajectoriesToReplay(forgets);
  expectTruthfulStatistics(forgets, 50);
}

TEST(LearnedSearches, ForgetUnusedTrajectories) {
  const level::Level level = learnedSearchCorridor();
  const Problem problem = support::endlessProblem(level);
  expectForgettingToShowNowhere<Pbge, PbgeSettings>(problem);
  expectForgettingToShowNowhere<Cflge, CflgeSettings>(problem);
}

// A rollout depends only on its start, its seed and the memory.
TEST(Cflge, RemembersThePlacesOfAnEarlierAnswer) {
  const level::Level level = learnedSearchCorridor();
  Problem problem = support::endlessProblem(level);
  ThreadPool pool(2);
  const auto stepsPlayed = [&](uint32_t ticks) {
    problem.known = {{{{0, true, false}, ticks}}};  // a walk down the corridor
    Cflge search(problem, 1, {}, {pool});
    search.tryWarmStarts(0, 1);
    const uint64_t before = search.statistics().steps;
    for (int r = 0; r < 20; ++r) search.round();
    return search.statistics().steps - before;
  };
  EXPECT_EQ(stepsPlayed(1), stepsPlayed(1));
  EXPECT_NE(stepsPlayed(375), stepsPlayed(1));
}

// Without learning, players rarely return to the places where earlier ones fell off the edges.
TEST(Pbge, LearnsToReturn) {
  const level::Level level = learnedSearchCorridor();
  const Problem problem = support::endlessProblem(level);
  ThreadPool pool(2);
  PbgeSettings dull;
  dull.learns = false;
  Pbge learned(problem, 1, {}, {pool}), untaught(problem, 1, dull, {pool});
  const double without = returnRate(untaught, 0, 60), with = returnRate(learned, 60, 120);
  EXPECT_LT(without, 0.05);
  EXPECT_GT(with, 4 * without + 0.1);
  EXPECT_GT(learned.cellCount(), untaught.cellCount());
}

TEST(Cflge, LearnsTheModuleAndToReturn) {
  const level::Level level = learnedSearchCorridor();
  const Problem problem = support::endlessProblem(level);
  ThreadPool pool(2);
  CflgeSettings dull;
  dull.learns = false;
  Cflge search(problem, 1, {}, {pool}), untaught(problem, 1, dull, {pool});
  const double without = returnRate(untaught, 20, 60), with = returnRate(search, 150, 220);
  const std::vector<float>& losses = search.moduleLosses();
  EXPECT_NEAR(losses.front(), logOf(float(policy::kMoves)), 0.5f);
  EXPECT_LT(losses.back(), 0.65f * losses.front());
  EXPECT_LT(without, 0.2);
  EXPECT_GT(with, 4 * without);
  EXPECT_GT(with, 0.6);
  float farthest = 0;
  for (const Vec3 place : search.places(0)) farthest = std::max(farthest, -place.z);
  EXPECT_GT(farthest, 60);  // twice as far as players get at random
}

template <class S, class Settings>
std::vector<Vec3> placesOf(const Problem& problem, int threads, int rounds) {
  ThreadPool pool(threads);
  S search(problem, 3, Settings{}, {pool});
  for (int r = 0; r < rounds; ++r) search.round();
  std::vector<Vec3> places = search.places(0);
  places.push_back({float(search.statistics().steps), float(search.singletons()), 0});
  return places;
}

// There are enough rounds to learn, so the learned weights decide the play.
TEST(LearnedSearches, AreTheSameOnAnyNumberOfThreads) {
  const level::Level level = learnedSearchCorridor();
  const Problem problem = support::endlessProblem(level);
  const auto pbge = placesOf<Pbge, PbgeSettings>(problem, 1, 12);
  const auto cflge = placesOf<Cflge, CflgeSettings>(problem, 1, 16);
  for (const int threads : {2, 3}) {
    EXPECT_TRUE((placesOf<Pbge, PbgeSettings>(problem, threads, 12) == pbge)) << threads;
    EXPECT_TRUE((placesOf<Cflge, CflgeSettings>(problem, threads, 16) == cflge)) << threads;
  }
}

// A known solution is found before the first round, and the search continues from it.
TEST(LearnedSearches, TryEarlierAnswersFirst) {
  const level::Level stones = steppingStones().compile();
  PlainQuery asked(stones);
  Problem problem = asked.problem();
  ThreadPool pool(2);
  Pbge search(problem, 1, {}, {pool});
  while (search.goals().empty()) {
    ASSERT_LT(search.statistics().steps, 3'000'000u);
    search.round();
  }
  const Trajectory found = search.trajectoryTo(search.goals()[0]);
  EXPECT_EQ(found.end.outcome, sim::Outcome::goal);
  problem.known = {found.actions};
  const auto again = [&](LearnedSearch& s) {
    s.tryWarmStarts(0, 1);
    ASSERT_EQ(s.goals().size(), 1u);
    EXPECT_EQ(sim::stateHash(s.trajectoryTo(s.goals()[0]).end), sim::stateHash(found.end));
    EXPECT_GT(s.cellCount(), 20u);
    for (int r = 0; r < 3; ++r) s.round();
    for (uint32_t c = 0; c < s.cellCount(); ++c) {
      const Trajectory p = s.trajectoryTo(s.archive().nodes()[s.archive().node(c)]);
      ASSERT_EQ(sim::stateHash(p.end), sim::stateHash(s.archive().world(c)));
    }
  };
  Pbge pbge(problem, 2, {}, {pool});
  again(pbge);
  Cflge cflge(problem, 2, {}, {pool});
  again(cflge);
}

// Levels with waypoints, movers and parts to touch. The verifier checks each trajectory.
TEST(LearnedSearches, SolveLevels) {
  const std::tuple<const char*, const char*, const char*> queries[] = {
      {"pbge", "kill-checkerboard", "left-file"},
      {"cflge", "kill-checkerboard", "left-file"},
      {"pbge", "truss-tower", "landing-on-foot"},
      {"cflge", "presses", "through"},
      {"pbge", "touch-lift", "up"},
      {"cflge", "touch-lift", "up"},
  };
  for (const auto& [method, level, query] : queries) {
    FilterOptions o;
    o.threads = 2;
    o.solver.method = findMethod(method);
    o.solver.budget.maxSteps = 3'000'000;
    o.solver.progressRecords = false;
    o.only = {query};
    const Filtered f =
        runFilter(std::string(OBBY_SOURCE_DIR "/levels/") + level + ".jsonl", std::move(o));
    EXPECT_TRUE(f.status);
    EXPECT_EQ(f.counts.solved, 1u) << method << " " << level << " " << query;
  }
}

template <class S, class Settings>
std::vector<Vec3> placesUnder(const Settings& settings, int rounds) {
  const level::Level level = learnedSearchCorridor();
  const Problem problem = support::endlessProblem(level);
  ThreadPool pool(2);
  S search(problem, 3, settings, {pool});
  for (int r = 0; r < rounds; ++r) search.round();
  return search.places(0);
}

// A part of the method has an effect if leaving it out changes the result.
TEST(Pbge, EachOfItsPartsHasAnEffect) {
  const auto under = [](auto&& change) {
    PbgeSettings settings;
    change(settings);
    return placesUnder<Pbge>(settings, 24);
  };
  const std::vector<Vec3> whole = under([](PbgeSettings&) {});
  EXPECT_TRUE(under([](PbgeSettings&) {}) == whole);
  EXPECT_FALSE(under([](PbgeSettings& s) { s.unrest = 0; }) == whole) << "left to chance";
  EXPECT_FALSE(under([](PbgeSettings& s) { s.policy.imitation = 0; }) == whole) << "imitation";
  EXPECT_FALSE(under([](PbgeSettings& s) { s.policy.loss.entropyWeight = 0; }) == whole);
  EXPECT_FALSE(under([](PbgeSettings& s) { s.last = s.subgoal; }) == whole) << "the last sub-goal";
  EXPECT_FALSE(under([](PbgeSettings& s) { s.aimFor = 1'000'000; }) == whole) << "other places";
}

TEST(Cflge, EachOfItsPartsHasAnEffect) {
  const auto under = [](auto&& change) {
    CflgeSettings settings;
    change(settings);
    return placesUnder<Cflge>(settings, 24);
  };
  const std::vector<Vec3> whole = under([](CflgeSettings&) {});
  EXPECT_TRUE(under([](CflgeSettings&) {}) == whole);
  EXPECT_FALSE(under([](CflgeSettings& s) { s.policy.hindsight = 0; }) == whole) << "hindsight";
  EXPECT_FALSE(under([](CflgeSettings& s) { s.moduleSteps = 0; }) == whole) << "latent space";
  EXPECT_FALSE(under([](CflgeSettings& s) { s.chance = 0; }) == whole) << "random moves";
  EXPECT_FALSE(under([](CflgeSettings& s) { s.refresh = 1ull << 40; }) == whole) << "new goals";
}

}  // namespace
}  // namespace obby::baselines
