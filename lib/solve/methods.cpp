#include "solve/methods.h"

#include "solve/search/methods/go_explore_method.h"
#include "solve/search/resident/resident_explore.h"
#include "solve/search/selectors/beam_selector.h"
#include "solve/search/selectors/mcts_selector.h"
#include "solve/search/selectors/mixed_selector.h"
#include "solve/search/selectors/policy_selector.h"
#include "solve/search/selectors/rrt_selector.h"

namespace obby::solve {

namespace {

GoExploreSettings policyFirstSettings() {
  GoExploreSettings s = plainSettings();
  s.byPolicy = true;
  return s;
}

SearchOutcome runResident(const Problem& p, const Budget& b, const Watcher& w, const Machine& m) {
  return runSearch(
      p, b, w, [&] { return std::make_unique<ResidentExplore>(p, b.seed, ResidentSettings{}, m); });
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> table = {
      {"auto", "half aimed, half beam, with help from a trained policy; the best choice",
       runGoExplore<guidedSettings, makeMixedSelector>},
      {"aimed", "Go-Explore from standing states with jumps aimed at surfaces",
       runGoExplore<aimedSettings, hedgedSelector>},
      {"ge", "Go-Explore as published, from any state with random actions",
       runGoExplore<plainSettings, plainSelector>},
      {"rrt", "rapidly exploring random tree (RRT)", runGoExplore<rrtSettings, makeRrtSelector>},
      {"mcts", "Monte Carlo tree search (UCT) with aimed jumps as moves",
       runGoExplore<mctsSettings, makeMctsSelector>},
      {"beam", "beam search, which like A* expands the most promising states first",
       runGoExplore<beamSettings, makeBeamSelector>},
      {"ge-ps", "ge, but a trained policy plays first from each new state",
       runGoExplore<policyFirstSettings, makePolicyFirstSelector>},
      {"rl", "a trained policy alone, always from the start",
       runGoExplore<aloneSettings, makePolicyAloneSelector>},
      {"resident", "Go-Explore for GPUs: archive and rollouts stay on the device", runResident},
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
