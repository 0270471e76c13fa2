#include "suite/plan.h"

#include <algorithm>

namespace obby::bench {
namespace {

constexpr size_t kSampleEvery = 3;

}  // namespace

bool Plan::asks(size_t method, size_t query, uint64_t seed) const {
  if (method == 0) return suite[query].solvable() || seed == 1;
  return suite[query].solvable() && (!sampled || query % kSampleEvery == 0);
}

double Plan::capOf(const SuiteQuery& query) const {
  return query.solvable() ? cap : std::min(cap, unsolvableCap);
}

std::vector<Trial> Plan::trialsAt(size_t query, uint64_t seed) const {
  std::vector<Trial> all;
  for (size_t m = 0; m < methods.size(); ++m) {
    if (asks(m, query, seed)) all.push_back({suite[query], *methods[m], seed, capOf(suite[query])});
  }
  return all;
}

std::vector<Trial> Plan::trials() const {
  std::vector<Trial> all;
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    for (size_t q = 0; q < suite.size(); ++q) {
      for (const Trial& trial : trialsAt(q, seed)) all.push_back(trial);
    }
  }
  return all;
}

Made machineOf(const std::vector<Trial>& trials, const RunLog& log, const Maker& maker) {
  std::vector<std::string> keys;
  for (const Trial& trial : trials) keys.push_back(plannedRun(trial, 0).key());
  return log.mostlyBy(keys, maker);
}

Results resultsOf(const Plan& plan, const RunLog& log, const Maker& maker) {
  Results results;
  results.cap = plan.cap;
  for (const SuiteQuery& q : plan.suite)
    results.queries.push_back({q.name(), q.expected, q.effort});
  for (const solve::Method* method : plan.methods) {
    results.methods.emplace_back(method->name);
    results.runs.emplace_back(plan.suite.size());
  }
  for (size_t q = 0; q < plan.suite.size(); ++q) {
    for (uint64_t seed = 1; seed <= plan.seeds; ++seed) {
      Maker one = maker;
      if (!plan.anyMachine) one.machine = machineOf(plan.trialsAt(q, seed), log, maker).machine;
      for (size_t m = 0; m < plan.methods.size(); ++m) {
        const Trial trial{plan.suite[q], *plan.methods[m], seed, plan.capOf(plan.suite[q])};
        const Run* run = log.find(plannedRun(trial, 0).key(), one);
        if (run) results.runs[m][q].push_back(*run);
      }
    }
  }
  return results;
}

}  // namespace obby::bench
