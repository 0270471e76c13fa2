// Makes rows of a method table for Go-Explore in rounds, from settings and a selector.
#pragma once

#include "solve/search/methods/go_explore.h"
#include "solve/search/run_search.h"

namespace obby::solve {

template <GoExploreSettings (*settings)(), MakeSelector makeSelector>
SearchOutcome runGoExplore(const Problem& p, const Budget& b, const Watcher& w, const Machine& m) {
  return runSearch(
      p, b, w, [&] { return std::make_unique<GoExplore>(p, b.seed, settings(), m, makeSelector); });
}

// Short rollouts that keep standing states only. Most macros are aimed at surfaces.
inline GoExploreSettings aimedSettings() { return {}; }

// The same, with a policy that explores from new states, if there is one.
inline GoExploreSettings guidedSettings() {
  GoExploreSettings s;
  s.byPolicy = true;
  return s;
}

// As published: 8,192 worlds in lockstep, every visited state is examined, and actions are random.
// Rollouts last 120 ticks: a policy's worth shows only after a jump or two (docs/methods.md).
inline GoExploreSettings plainSettings() {
  GoExploreSettings s;
  s.rollouts = s.maxRollouts = 8192;
  s.phaseJumps = 0;
  s.minPhase = 120;
  s.groundedOnly = false;
  s.lookEvery = 1;
  s.cellWidth = 1;
  s.explore.aimShare = 0;
  return s;
}

}  // namespace obby::solve
