// The data that the rollouts of a search read, made once from its problem and settings.
#pragma once

#include <memory>

#include "policy/policy.h"
#include "solve/model/problem.h"
#include "solve/search/archive/cell.h"
#include "solve/search/archive/clock_map.h"
#include "solve/search/guidance/beam_rank.h"
#include "solve/search/guidance/potential.h"
#include "solve/search/rollouts/explore_context.h"
#include "solve/search/rollouts/rollout_kernel.h"
#include "solve/search/rollouts/surfaces.h"

namespace obby::solve {

// The defaults were measured over levels/ (ticks to the first solution).
struct GoExploreSettings {
  uint32_t rollouts = 8;       // per round at first: small rounds answer easy queries soon
  uint32_t maxRollouts = 512;  // per round in a long search: keeps all threads busy
  float phaseJumps = 4;        // length of a rollout, in air times of a flat jump
  uint32_t minPhase = 40;      // min ticks of a rollout
  float cellWidth = 2;         // studs at 16 studs/s; grows with walking speed
  bool groundedOnly = true;    // keep only states that stand or have long been in the air
  uint32_t lookEvery = 3;      // ticks between looks at a state; a walk crosses a cell in seven
  ExploreSettings explore;
  bool byPolicy = false;  // some rollouts use the policy, if the problem has one
};

class ExploreSetup {
 public:
  // The level and the query must outlive the setup.
  ExploreSetup(const Problem& problem, uint64_t seed, const GoExploreSettings& settings);
  ExploreSetup(const ExploreSetup&) = delete;
  ExploreSetup& operator=(const ExploreSetup&) = delete;

 private:
  const Surfaces surfaces_;
  const ClockMap clock_;
  const std::unique_ptr<const policy::Pilot> pilot_;

 public:
  const RolloutRules rules;
  const Potential potential;
  const BeamRoute beam;
};

}  // namespace obby::solve
