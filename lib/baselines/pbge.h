// Policy-Based Go-Explore (Ecoffet et al. 2021). Players return to a selected cell of the archive
// by a policy that learns to reach the cells on the way. Half of them then explore by the policy,
// half at random. Exploration is not learned from, and no state is restored. Host only.
#pragma once

#include "baselines/cell_choice.h"
#include "baselines/goal_policy.h"
#include "baselines/learned_search.h"
#include "baselines/names.h"
#include "solve/search/rollouts/action_runs.h"

namespace obby::baselines {

struct PbgeSettings {
  uint32_t groups = 2;      // groups of kGroup players; one thread each
  uint32_t decisions = 32;  // decisions per player and round
  uint32_t patience = 100;  // decisions until a player gives up: in addition to those that the
                            // followed trajectory took to the sub-goal, or since the last new cell
  uint32_t aimFor = 20;     // exploring decisions until a new aim
  uint32_t calm = 50;       // exploring decisions without a new cell before entropy is raised
  float unrest = 0.01f;     // temperature: 1 + (unrest x decisions)^2
  float subgoal = 0.1f;     // reward of a sub-goal
  float last = 0.3f;        // reward of the last sub-goal
  bool learns = true;       // false: the policy stays untrained
  size_t forgetFrom = kForgetFrom;
  GoalPolicySettings policy;
};

class Pbge final : public LearnedSearch {
 public:
  static constexpr uint32_t kGroup = 16;  // players; the last one replays kept trajectories

  Pbge(const Problem& problem, uint64_t seed, const PbgeSettings& settings, const Machine& machine);

  const Returns& returns() const { return returns_; }

 private:
  enum class Mode : uint8_t { returning, exploring, repeating };

  struct Player {
    Player(uint64_t seed, uint64_t stream, bool repeater)
        : random(seed, stream), repeats(repeater) {}

    Random random;
    bool repeats;  // replays kept trajectories once there are any
    Episode episode;
    Mode mode = Mode::returning;
    size_t kept = 0, subgoals = 0;  // the first cells of passed(kept) are its sub-goals
    size_t next = 0;                // next sub-goal
    bool byPolicy = true;           // explores by the policy
    Vec3 aim{};                     // target of that exploration
    uint32_t explored = 0;          // exploring decisions
    uint32_t waited = 0;            // decisions since the last sub-goal or new cell
    uint32_t newCells = 0;          // Episode::newCells at that time
    RandomKeys keys;
    RunCursor cursor;  // position in the replayed trajectory
    // Members of the current decision.
    Turns ahead = 0;
    sim::Action action;
    float reward = 0;
    bool done = false;  // later rewards do not count
  };
  // Players whose ticks run together, and their results of a round.
  struct Group {
    std::vector<Player> players;
    std::vector<Episode> ended;
    std::vector<uint32_t> acted;  // cell of each action in the archive's cells
    NetPass pass;
    Returns returns;
    uint64_t steps = 0;
  };

  void playAndLearn() override;
  void markFollowed(std::vector<uint8_t>& used) const override;
  void play(std::span<Group> groups, uint32_t first);
  View lookFrom(Player& p) const;
  void decide(Group& g, Player& p, const float* outputs, size_t row);
  void decideByPolicy(Player& p, const float* outputs, size_t row);
  void decideAsKept(Player& p, size_t row);
  void tick(std::span<Group> groups);
  void reach(Group& g, Player& p) const;
  uint32_t decisionsDue(const Player& p) const;
  bool isOver(const Player& p) const;
  void endDecision(Group& g, Player& p, size_t row);
  void restart(Group& g, Player& p) const;
  void explore(Player& p) const;
  void aim(Player& p) const;
  Vec3 placeNear(Player& p) const;

  const PbgeSettings settings_;
  GoalPolicy policy_;
  CellChoice choice_;
  Decisions made_;
  std::vector<Group> groups_;
  Returns returns_;
};

}  // namespace obby::baselines
