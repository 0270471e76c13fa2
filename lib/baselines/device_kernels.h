// The kernel for observations of players in learned methods. Results have the same bits as the
// CPU's.
#pragma once

#include "baselines/names.h"
#include "policy/observation.h"

namespace obby::baselines {

// Inputs that all observations share.
struct SightRules {
  level::LevelView level;
  level::QueryView query;
  policy::SurroundingsView surroundings;
};

template <class Table>
OBBY_DEVICE void forTables(SightRules& r, Table&& table) {
  forTables(r.level, table);
  forTables(r.query, table);
  forTables(r.surroundings, table);
}

// A player that looks toward `ahead` and has to reach `next`.
struct Looker {
  sim::World world;
  geom::Region next;
  Turns ahead;
};

struct SightArguments {
  SightRules rules;
  const Looker* players;         // (players)
  const sim::RigidBody* bodies;  // (players, level.bodyCount)
  float* inputs;                 // (players, policy::kInputs)
};

// `i` runs over (players, policy::kViewThreads).
OBBY_DEVICE void seePart(const SightArguments& a, uint32_t i) {
  const uint32_t p = i / policy::kViewThreads, part = i % policy::kViewThreads;
  if (part >= uint32_t(policy::kViewParts)) return;
  const Looker& player = a.players[p];
  const policy::Scene scene{a.rules.level, a.rules.query, a.rules.surroundings};
  sim::NextRegion next;
  next.region = &player.next;
  const size_t bodyCount = a.rules.level.bodyCount;
  policy::observePart(scene, player.world, a.bodies + p * bodyCount, next, player.ahead, int(part),
                      a.inputs + size_t(p) * policy::kInputs);
}

}  // namespace obby::baselines
