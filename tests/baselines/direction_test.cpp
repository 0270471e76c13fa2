// Learning within a search goes in the right direction: better moves become likelier, sparse places
// become goals, moves that reach a goal are preferred, and deaths are avoided.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

#include "baselines/goal_policy.h"
#include "baselines/goal_pool.h"
#include "baselines/inverse_dynamics.h"
#include "baselines/quantile_policy.h"
#include "policy/policy.h"

namespace obby::baselines {
namespace {

// Decisions at one place, with moves 4 and 9 in turn.
struct OnePlace {
  OnePlace() : d(16, 4) {
    Random random(10, 10);
    for (int k = 0; k < policy::kInputs; ++k) {
      const float seen = 2 * random.unit() - 1;
      for (size_t r = 0; r < d.rows(); ++r) d.inputs[r * policy::kInputs + size_t(k)] = seen;
    }
    std::fill(d.done.begin(), d.done.end(), uint8_t(1));
  }
  std::vector<float> chances(const GoalPolicy& pupil, float sharpness = 1) const {
    nn::Pass<float> pass;
    const float* const out = pass.forward(pupil.net(), nn::DenseRows<float>{d.inputs.data(), 1});
    float logits[policy::kMoves];
    for (int m = 0; m < policy::kMoves; ++m) logits[m] = out[m] * sharpness;
    std::vector<float> p(policy::kMoves);
    policy::probabilitiesOf(logits, true, p.data());
    return p;
  }
  // Learns from decisions that `maker` made under the current policy. Move 4 is worth `worth` more
  // than move 9.
  void teach(GoalPolicy& pupil, ThreadPool& pool, Maker maker, float worth, float sharpness = 1) {
    const std::vector<float> p = chances(pupil, sharpness);
    for (size_t r = 0; r < d.rows(); ++r) {
      const int move = r % 2 == 0 ? 4 : 9;
      d.made[r] = {{move, logOf(p[size_t(move)]), 0, 0}, true};
      d.makers[r] = maker;
      d.sharpness[r] = sharpness;
      d.values[r] = 0.5f;
      d.rewards[r] = 0.5f + (move == 4 ? 0.5f : -0.5f) * worth;
    }
    pupil.learn(pool, d);
  }
  Decisions d;
};

TEST(GoalPolicy, MakesBetterMovesLikelier) {
  ThreadPool pool(1);
  for (const Maker maker : {Maker::policy, Maker::kept}) {
    OnePlace place;
    GoalPolicy pupil({}, 1);
    for (int n = 0; n < 40; ++n) place.teach(pupil, pool, maker, 1);
    const std::vector<float> p = place.chances(pupil);
    EXPECT_GT(p[4], 2 * p[9]) << int(maker);
    EXPECT_GT(p[4], 2.0f / float(policy::kMoves)) << int(maker);
  }
}

// Moves are drawn with flatter probabilities than the network's own. If the loss divided by the
// network's own probability, the ratio would be clipped and nothing learned.
TEST(GoalPolicy, LearnsWithTheSharpnessOfTheChoice) {
  constexpr float kSharpness = 0.25f;
  ThreadPool pool(1);
  GoalPolicySettings settings;
  settings.loss.entropyWeight = 0;
  settings.loss.valueWeight = 0;
  GoalPolicy pupil(settings, 1);
  OnePlace place;
  for (int n = 0; n < 40 && place.chances(pupil)[4] < 0.2f; ++n)
    place.teach(pupil, pool, Maker::policy, 1);
  for (int n = 0; n < 100; ++n) place.teach(pupil, pool, Maker::policy, 0);  // lets Adam settle
  const std::vector<float> own = place.chances(pupil), made = place.chances(pupil, kSharpness);
  ASSERT_GT(own[4], 1.3f * made[4]);
  ASSERT_LT(own[9], 0.7f * made[9]);
  const std::vector<float> before = pupil.net().parameters();
  place.teach(pupil, pool, Maker::policy, 1, kSharpness);
  float moved = 0;
  for (size_t i = 0; i < before.size(); ++i)
    moved = std::max(moved, std::abs(pupil.net().parameters()[i] - before[i]));
  EXPECT_GT(moved, 2e-6f);
  EXPECT_GT(place.chances(pupil)[4], own[4]);
}

// Nine of ten places lie in one corner, and the others are far apart. In the last place the player
// is in the air.
TEST(GoalPool, DrawsSparsePlacesWithAStandingPlayer) {
  constexpr uint32_t kPlaces = 1000;
  Random random(11, 11);
  const auto path = std::make_shared<Path>();
  const auto add = [&](float wide, bool stands) {
    float place[kPlace] = {};
    for (size_t k = 0; k < 3; ++k) place[k] = wide * (2 * random.unit() - 1);
    path->places.insert(path->places.end(), place, place + kPlace);
    path->stands.push_back(uint8_t(stands));
  };
  add(0, true);  // the start is never a goal
  for (uint32_t i = 1; i <= kPlaces; ++i) add(i % 10 == 0 ? 100.0f : 0.01f, true);
  add(10'000, false);
  GoalPool goals;
  ThreadPool pool(2);
  const InverseDynamics module(1);
  goals.add(path);
  EXPECT_TRUE(goals.empty());
  NetPass pass;
  goals.refresh(pool, module, pass);
  ASSERT_FALSE(goals.empty());
  constexpr int kDraws = 20'000;
  int sparse = 0;
  for (int n = 0; n < kDraws; ++n) {
    const uint32_t index = goals.draw(random).index;
    ASSERT_GE(index, 1u);
    ASSERT_LE(index, kPlaces);
    sparse += index % 10 == 0 ? 1 : 0;
  }
  EXPECT_NEAR(sparse / double(kDraws), 0.397,
              0.03);  // the share for the 100 sparsest of 1,000 places
}

// Trajectories of one decision each. All start at one place and have the same goal.
struct OneDecision {
  static constexpr float kGoal = 40;

  void play(int move, float to, bool died) {
    const auto path = std::make_shared<Path>();
    path->places.resize(2 * kPlace);
    path->places[kPlace] = to;
    path->stands = {1, 1};
    const auto track = std::make_shared<Track>();
    track->path = path;
    track->inputs.resize(2 * size_t(policy::kInputs));
    track->mayJump = {1, 1};
    track->moves = {uint8_t(move)};
    track->goals.resize(2 * kPlace);
    track->goals[0] = track->goals[kPlace] = kGoal;
    track->ended = died;
    memory.add(track);
  }
  // Returns the predicted cost of each move after this number of learning steps.
  std::vector<float> learned(float rate, int steps) const {
    QuantileSettings settings;
    settings.hindsight = 0;
    settings.refresh = 1u << 30;
    settings.learner.learningRate = rate;
    QuantilePolicy pupil(settings, 1);
    ThreadPool pool(1);
    const InverseDynamics module(1);
    for (int n = 0; n < steps; ++n) pupil.learn(pool, memory, module);
    std::vector<float> inputs(kPolicyInputs);
    float place[kPlace] = {}, goal[kPlace] = {};
    goal[0] = kGoal;
    observeGoal(place, goal, inputs.data() + policy::kInputs);
    nn::Pass<float> pass;
    const float* out = pass.forward(pupil.net(), nn::DenseRows<float>{inputs.data(), 1});
    std::vector<float> means;
    for (int m = 0; m < policy::kMoves; ++m, out += kQuantiles)
      means.push_back(std::accumulate(out, out + kQuantiles, 0.0f) / float(kQuantiles));
    return means;
  }
  Memory memory{100};
};

TEST(QuantilePolicy, PrefersMovesThatComeToTheGoal) {
  OneDecision one;
  one.play(2, OneDecision::kGoal, false);
  one.play(4, 0, false);
  const std::vector<float> means = one.learned(3e-3f, 200);
  EXPECT_GT(means[2], means[4] + 0.5f);
}

TEST(QuantilePolicy, FearsDeathMoreThanNotArriving) {
  OneDecision one;
  one.play(4, 0, false);
  one.play(6, 0, true);
  const std::vector<float> means = one.learned(1e-2f, 120);
  EXPECT_GT(means[4], means[6] + 5);
}

}  // namespace
}  // namespace obby::baselines
