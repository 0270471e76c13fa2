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

std::vector<Question> Plan::questions() const {
  std::vector<Question> all;
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    for (size_t q = 0; q < suite.size(); ++q) {
      for (size_t m = 0; m < methods.size(); ++m) {
        if (asks(m, q, seed)) all.push_back({suite[q], *methods[m], seed, capOf(suite[q])});
      }
    }
  }
  return all;
}

Results resultsOf(const Plan& plan, const RunLog& log, const Maker& maker) {
  Results results;
  results.cap = plan.cap;
  for (const SuiteQuery& q : plan.suite)
    results.queries.push_back({q.name(), q.expected, q.effort});
  for (const solve::Method* method : plan.methods) {
    results.methods.emplace_back(method->name);
    auto& ofMethod = results.runs.emplace_back();
    for (const SuiteQuery& q : plan.suite) {
      auto& ofQuery = ofMethod.emplace_back();
      for (uint64_t seed = 1; seed <= plan.seeds; ++seed) {
        const Run* run = log.find(plannedRun({q, *method, seed, plan.capOf(q)}, 0).key(), maker);
        if (run) ofQuery.push_back(*run);
      }
    }
  }
  return results;
}

}  // namespace obby::bench
