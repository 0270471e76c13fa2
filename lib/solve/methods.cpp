#include "solve/methods.h"

#include "solve/choosers/choose_beam.h"
#include "solve/choosers/choose_mcts.h"
#include "solve/choosers/choose_mixed.h"
#include "solve/choosers/choose_policy.h"
#include "solve/choosers/choose_rrt.h"
#include "solve/go_explore_method.h"
#include "solve/learned/cflge.h"
#include "solve/learned/pbge.h"
#include "solve/resident/resident_explore.h"

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

SearchOutcome runPbge(const Problem& p, const Budget& b, const Watcher& w, const Machine& m) {
  return runSearch(p, b, w, [&] {
    return std::make_unique<learned::Pbge>(p, b.seed, learned::PbgeSettings{}, m);
  });
}

SearchOutcome runCflge(const Problem& p, const Budget& b, const Watcher& w, const Machine& m) {
  return runSearch(p, b, w, [&] {
    return std::make_unique<learned::Cflge>(p, b.seed, learned::CflgeSettings{}, m);
  });
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> table = {
      {"auto",
       "aimed and beam, each with half of the attempts; a trained policy tries new states first",
       runGoExplore<guidedSettings, makeMixedChooser>},
      {"aimed", "Go-Explore over standing states with jumps aimed at surfaces",
       runGoExplore<aimedSettings, hedgedSelector>},
      {"ge", "Go-Explore with random actions over all states, as published",
       runGoExplore<plainSettings, plainSelector>},
      {"rrt", "random tree (RRT): from the nearest state toward a random place",
       runGoExplore<rrtSettings, makeRrtChooser>},
      {"mcts", "Monte-Carlo tree search (UCT) whose moves are jumps aimed at surfaces",
       runGoExplore<mctsSettings, makeMctsChooser>},
      {"beam", "beam search, A*-like: the states first that promise the shortest way",
       runGoExplore<beamSettings, makeBeamChooser>},
      {"ge-ps", "ge whose rollouts from a state that is new are a trained policy's",
       runGoExplore<policyFirstSettings, makePolicyFirstChooser>},
      {"rl", "a trained policy alone, from the start, again and again",
       runGoExplore<aloneSettings, makePolicyAloneChooser>},
      {"pbge",
       "ge that restores nothing: returns and explores by a policy that it trains meanwhile",
       runPbge},
      {"cflge",
       "draws goals where a latent space that it learns is sparse, returns by a policy it trains",
       runCflge},
      {"resident", "archive, choice and merge in kernels, thousands of rollouts a round: for GPUs",
       runResident},
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
