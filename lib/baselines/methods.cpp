#include "baselines/methods.h"

#include "baselines/cflge.h"
#include "baselines/pbge.h"
#include "solve/search/run_search.h"

namespace obby::baselines {

namespace {

SearchOutcome runPbge(const Problem& p, const Budget& b, const Watcher& w, const Machine& m) {
  return runSearch(p, b, w, [&] { return std::make_unique<Pbge>(p, b.seed, PbgeSettings{}, m); });
}

SearchOutcome runCflge(const Problem& p, const Budget& b, const Watcher& w, const Machine& m) {
  return runSearch(p, b, w, [&] { return std::make_unique<Cflge>(p, b.seed, CflgeSettings{}, m); });
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> table = {
      {"pbge", "ge, but a policy that it trains returns to states and explores", runPbge},
      {"cflge",
       "trains a policy to reach goals drawn from sparse regions of a learned latent space",
       runCflge},
  };
  return table;
}

}  // namespace obby::baselines
