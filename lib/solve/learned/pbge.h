// Policy-Based Go-Explore (Ecoffet et al. 2021): players return to a chosen cell of the archive by
// a policy that learns meanwhile to reach the cells on the way there, and explore from it, half of
// them by the policy, half at random. Nothing is learned from exploring, nothing ever restored.
// Host only.
#pragma once

#include "solve/learned/cell_choice.h"
#include "solve/learned/goal_policy.h"
#include "solve/learned/learned_search.h"
#include "solve/search/rollouts/known_way.h"

namespace obby::solve::learned {

struct PbgeSettings {
  uint32_t groups = 2;      // of kGroup players; a group is one thread's
  uint32_t decisions = 32;  // of each player, a round
  uint32_t patience = 100;  // decisions until a player gives up: beyond those that a sub-goal took
                            // at first, or of exploring without a new cell
  uint32_t aimFor = 20;     // decisions of exploring until another place is aimed at
  uint32_t calm = 50;       // decisions of exploring without a new cell before entropy is raised
  float unrest = 0.01f;     // then the temperature is 1 + (unrest x decisions)^2
  float subgoal = 0.1f;     // reward
  float last = 0.3f;        // that of the last sub-goal
  bool learns = true;       // false: the policy stays as it was at first
  size_t forgetFrom = kForgetFrom;
  GoalPolicySettings policy;
};

class Pbge final : public LearnedSearch {
 public:
  static constexpr uint32_t kGroup = 16;  // players; the last of them repeats kept playthroughs

  Pbge(const Problem& problem, uint64_t seed, const PbgeSettings& settings, const Machine& machine);

  const Returns& returns() const { return returns_; }

 private:
  enum class Mode : uint8_t { returning, exploring, repeating };

  struct Player {
    Player(uint64_t seed, uint64_t stream, bool repeater)
        : random(seed, stream), repeats(repeater) {}

    Random random;
    bool repeats;  // plays what was kept, as soon as anything was
    Episode episode;
    Mode mode = Mode::returning;
    size_t way = 0, subgoals = 0;  // the cells to pass: the first of passed(way)
    size_t next = 0;               // of them
    bool byPolicy = true;          // explores so
    Vec3 aim{};                    // where to, then
    uint32_t explored = 0;         // decisions
    uint32_t waited = 0;           // decisions since the last sub-goal; exploring, new cell
    uint32_t newCells = 0;         // that the episode had found then
    RandomKeys keys;
    WayCursor cursor;  // of what it repeats
    // The decision at hand.
    Turns ahead = 0;
    sim::Action action;
    float reward = 0;
    bool done = false;  // nothing that comes later is due to it
  };
  // Players whose ticks are taken together, and what a round brought.
  struct Group {
    std::vector<Player> players;
    std::vector<Episode> ended;
    std::vector<uint32_t> acted;  // cells, one for each action there
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

}  // namespace obby::solve::learned
