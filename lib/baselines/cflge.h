// Cell-Free Latent Go-Explore (Gallouedec and Dellandrea 2023). It learns a latent space from how
// moves change places. A learned policy sends players along sub-goals to where that space is
// sparse, and they explore from there at random. The archive's cells are counted for statistics
// only. Host only.
#pragma once

#include "baselines/goal_pool.h"
#include "baselines/learned_search.h"
#include "baselines/names.h"
#include "baselines/quantile_policy.h"

namespace obby::baselines {

struct CflgeSettings {
  uint32_t groups = 2;            // groups of kGroup players; one thread each
  uint32_t decisions = 16;        // decisions per player and round
  uint32_t explore = 50;          // random decisions after the goal
  uint32_t patience = 100;        // decisions without a sub-goal until a player gives up
  float chance = 0.05f;           // probability of a random move
  uint64_t begin = 2048;          // decisions before learning begins
  uint64_t refresh = 5000;        // decisions between rankings of the goals
  float moduleSteps = 0.1f;       // learning steps of the module per decision
  float policySteps = 1.0f / 32;  // learning steps of the policy per decision
  size_t capacity = 40'000;       // decisions kept for the policy's learning
  bool learns = true;             // false: module and policy stay untrained
  size_t forgetFrom = kForgetFrom;
  QuantileSettings policy;
};

class Cflge final : public LearnedSearch {
 public:
  static constexpr uint32_t kGroup = 16;  // players

  Cflge(const Problem& problem, uint64_t seed, const CflgeSettings& settings,
        const Machine& machine);

  // Adds known trajectories to the memory and to the goals, like episodes.
  void tryWarmStarts(size_t first, size_t count) override;

  const Returns& returns() const { return returns_; }
  // Returns the mean losses of the inverse dynamics, one per round of learning.
  const std::vector<float>& moduleLosses() const { return moduleLosses_; }

 private:
  struct Player {
    Player(uint64_t seed, uint64_t stream) : random(seed, stream) {}

    Random random;
    Episode episode;
    std::shared_ptr<Path> path;
    Track track;
    std::vector<float> subgoals, points;  // (sub-goals, kPlace), (sub-goals, kLatent)
    size_t next = 0;                      // next sub-goal
    size_t count = 0;                     // number of sub-goals; 0: explores from the start
    uint32_t waited = 0;                  // decisions since the last sub-goal
    uint32_t explored = 0;                // random decisions so far
    RandomKeys keys;
    sim::Action action;
    bool explores() const { return next == count; }
  };
  struct Group {
    std::vector<Player> players;
    std::vector<Episode> ended;
    std::vector<Track> tracks;  // tracks of the ended episodes
    NetPass pass, encoder;
    std::vector<float> places, points;
    Returns returns;
    uint64_t steps = 0;
  };

  void playAndLearn() override;
  void remember(Track track);
  void follow(Player& p, const ActionRuns& warmStart);
  void play(std::span<Group> groups);
  View lookFrom(const Player& p) const;
  void look(Player& p, float* inputs);
  void note(Player& p, float* inputs) const;
  void decide(Player& p, const float* outputs);
  void tick(std::span<Group> groups);
  void reach(std::span<Group> groups);
  void endDecision(Group& g, Player& p);
  Track endOf(Player& p);
  void begin(Player& p) const;
  void restart(Group& g, Player& p);
  void encode(Group& g, Player& p) const;
  bool isOver(const Player& p) const;
  void learn();

  const CflgeSettings settings_;
  InverseDynamics module_;
  QuantilePolicy policy_;
  GoalPool goals_;
  NetPass ranking_;  // ranks the goals
  Memory memory_;
  std::vector<Group> groups_;
  Returns returns_;
  std::vector<float> moduleLosses_;
  uint64_t decided_ = 0, ranked_ = 0;       // decisions so far, and at the last ranking
  double moduleDebt_ = 0, policyDebt_ = 0;  // learning steps that are due
};

}  // namespace obby::baselines
