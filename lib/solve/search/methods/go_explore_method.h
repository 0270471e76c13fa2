// A row of a method table that is Go-Explore in rounds: its settings and its chooser.
#pragma once

#include "solve/search/methods/go_explore.h"
#include "solve/search/run_search.h"

namespace obby::solve {

template <GoExploreSettings (*settings)(), MakeChooser makeChooser>
SearchOutcome runGoExplore(const Problem& p, const Budget& b, const Watcher& w, const Machine& m) {
  return runSearch(
      p, b, w, [&] { return std::make_unique<GoExplore>(p, b.seed, settings(), m, makeChooser); });
}

// Short generations that keep standing states only, most macros aimed at surfaces.
inline GoExploreSettings aimedSettings() { return {}; }

// The same with a policy that explores from what is new, where there is one.
inline GoExploreSettings guidedSettings() {
  GoExploreSettings s;
  s.byPolicy = true;
  return s;
}

// As published: 8,192 worlds in step, every visited state is looked at, actions are held at random.
// Rollouts of 120 ticks: what a policy is worth shows only after a jump or two (docs/methods.md).
inline GoExploreSettings plainSettings() {
  GoExploreSettings s;
  s.rollouts = s.mostRollouts = 8192;
  s.phaseJumps = 0;
  s.leastPhase = 120;
  s.groundedOnly = false;
  s.lookEvery = 1;
  s.cellWidth = 1;
  s.explore.aimShare = 0;
  return s;
}

}  // namespace obby::solve
