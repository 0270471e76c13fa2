// Other players who press the same keys as the search's own player. A search for keys that serve
// all players keeps a state only if all of them have followed. Host only.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/model/problem.h"
#include "solve/search/rollouts/action_runs.h"
#include "solve/search/rollouts/explorer.h"

namespace obby::solve {

class Companions {
 public:
  class Walk;

  // The problem, which lists the companions, and the context must outlive this object.
  Companions(const Problem& problem, const ExploreContext& context, uint64_t seed);

  bool empty() const { return problem_.companions.empty(); }

  // Keeps the bodies of a walk for a new node. A later walk may start only from a node that was
  // kept.
  void keep(uint32_t node, const Walk& walk);

 private:
  struct Body {
    sim::World world;
    std::vector<sim::RigidBody> bodies;
  };
  // All bodies at one moment: the search's player, then the companions.
  using Party = std::vector<Body>;

  const Problem& problem_;
  const ExploreContext& context_;
  const uint64_t seed_;
  std::vector<Party> parties_;  // (nodes)
};

// A rollout that all players play, from a node that was kept.
class Companions::Walk {
 public:
  Walk(const Companions& all, uint32_t parent, uint64_t rollout);

  // Plays on until tick `ticks` of the rollout; calls must be in ascending order. Returns true if
  // every companion is near the player, has passed the same places, and stands if the player does.
  bool follow(uint32_t ticks);
  const sim::World& player() const { return party_.front().world; }

 private:
  friend class Companions;

  sim::Action next();
  void press(const sim::Action& action);
  bool near(const Body& other) const;

  const Companions& all_;
  Party party_;
  Explorer explorer_;
  RunCursor cursor_;
  const ActionRuns* runs_;  // null: the explorer's actions
  uint32_t ticks_ = 0;
};

}  // namespace obby::solve
