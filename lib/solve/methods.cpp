#include "solve/methods.h"

#include "solve/run_search.h"

namespace obby::solve {

namespace {

// Short generations that keep standing states only, most macros aimed at surfaces.
GoExploreSettings aimedSettings() { return {}; }

// As published: every visited state is kept, actions are held at random.
GoExploreSettings plainSettings() {
  GoExploreSettings s;
  s.rollouts = s.mostRollouts = 2048;
  s.phaseJumps = 0;
  s.groundedOnly = false;
  s.cellWidth = 1;
  s.explore.aimShare = 0;
  return s;
}

template <GoExploreSettings (*settings)(), MakeChooser makeChooser>
SearchOutcome run(const Problem& p, const Budget& b, const Watcher& w, const Machine& m) {
  return runSearch(p, b, settings(), w, m, makeChooser);
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> table = {
      {"auto", "Go-Explore over standing states with jumps aimed at surfaces",
       run<aimedSettings, hedgedSelector>},
      {"ge", "Go-Explore with random actions over all states, as published",
       run<plainSettings, hedgedSelector>},
  };
  return table;
}

const Method* findMethod(const std::string& name) {
  for (const Method& m : methods()) {
    if (name == m.name) return &m;
  }
  return nullptr;
}

}  // namespace obby::solve
