// Training and evaluation use the observation of the settings.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "policy/shipped_policy.h"
#include "train/evaluate.h"
#include "train/gaps.h"

namespace obby::train {
namespace {

constexpr Turns kOwnRoute = 12345;

// The same observation as policy::observe(), but a different function.
Turns asEver(const policy::Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
             float* inputs) {
  return policy::observe(scene, world, bodies, inputs);
}

// Always returns the same inputs and heading.
Turns blind(const policy::Scene&, const sim::World&, const sim::RigidBody*, float* inputs) {
  std::fill_n(inputs, policy::kInputs, 0.25f);
  return kOwnRoute;
}

// Records the observations of an evaluation on one thread.
std::vector<uint64_t>& shown() {
  static std::vector<uint64_t> states;
  return states;
}

template <policy::Observe kHow>
Turns watched(const policy::Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
              float* inputs) {
  shown().push_back(sim::stateHash(world));
  return kHow(scene, world, bodies, inputs);
}

constexpr uint32_t kLevels = 3;

std::vector<uint64_t> seeingJudged(const policy::Network& network, policy::Observe how) {
  ThreadPool pool(1);
  const std::atomic<bool> stop{false};
  EvaluationSettings settings;
  settings.levels = kLevels;
  settings.tries = 1;
  settings.observe = how;
  shown().clear();
  EXPECT_EQ(evaluate(network, Gaps(), settings, pool, stop).levels, kLevels);
  return shown();
}

// Plays with the actions that decide(scene, world) returns.
template <class Decide>
std::vector<uint64_t> played(Decide&& decide) {
  std::vector<uint64_t> states;
  for (uint64_t i = 0; i < kLevels; ++i) {
    const auto level = *Gaps().level(i, 1);
    const policy::Scene& scene = level->scene();
    const uint32_t max = maxTicksOf(*level, EvaluationSettings().patience);
    sim::World world = level->start();
    for (uint32_t t = 0; t < max && world.outcome == sim::Outcome::running;
         t += policy::kDecisionTicks) {
      states.push_back(sim::stateHash(world));
      const sim::Action action = decide(scene, world);
      for (uint32_t k = 0; k < policy::kDecisionTicks; ++k)
        sim::advance(world, nullptr, scene.level, &scene.query, action);
    }
  }
  return states;
}

TEST(Seeing, AnEvaluationUsesItsObservation) {
  const policy::Network& shipped = policy::shippedPolicy().network;
  const policy::Thinker thinker(shipped);
  const auto expected = played([&](const policy::Scene& scene, const sim::World& world) {
    return policy::decide(scene, thinker.view(), world, nullptr, nullptr);
  });
  EXPECT_GT(expected.size(), 30u);
  EXPECT_EQ(seeingJudged(shipped, watched<asEver>), expected);
  const auto straight = played([](const policy::Scene&, const sim::World&) {
    return policy::actionOf(0, kOwnRoute);  // the network gives all moves the same probability
  });
  EXPECT_EQ(seeingJudged(policy::Network(), watched<blind>), straight);
}

TEST(Seeing, AnEnvGroupUsesItsObservation) {
  const Gaps gaps;
  EnvGroupSettings settings;
  settings.levels = 2;
  settings.worlds = 4;
  settings.observe = blind;
  EnvGroup envGroup(gaps, settings, 1, 0, 1);
  ASSERT_TRUE(envGroup.begin(1));
  std::vector<float> rows(size_t(envGroup.size()) * policy::kInputs);
  std::vector<uint8_t> mayJump(envGroup.size());
  envGroup.observe(rows.data(), mayJump.data());
  EXPECT_TRUE(std::all_of(rows.begin(), rows.end(), [](float v) { return v == 0.25f; }));
  const EnvGroupState state = envGroup.state();
  for (const PlaceState& place : state.places) {
    for (const Player& p : place.players) EXPECT_EQ(p.ahead, kOwnRoute);
  }
}

TEST(Seeing, AnotherObservationLearnsAnotherPolicy) {
  const Gaps gaps;
  const auto learned = [&](policy::Observe how) {
    TrainerSettings settings = tiny();
    settings.envGroup.observe = how;
    ThreadPool pool(2);
    const auto trainer = Trainer::make(settings, gaps, pool, alone());
    EXPECT_TRUE(trainer);
    for (int i = 0; i < 2; ++i) EXPECT_TRUE((*trainer)->iterate());
    return (*trainer)->network().numbers();
  };
  const std::vector<float> expected = learned(EnvGroupSettings().observe);
  EXPECT_EQ(learned(asEver), expected);
  EXPECT_NE(learned(blind), expected);
}

}  // namespace
}  // namespace obby::train
