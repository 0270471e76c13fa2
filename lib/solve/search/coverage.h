// Measures the coverage of a search that found nothing: how the cells grew over its steps, and the
// probability that another rollout finds a new one.
#pragma once

#include <cstdint>
#include <vector>

#include "schema/obby.capnp.h"
#include "solve/search/search.h"

namespace obby::solve {

// Coverage after a number of steps.
struct CoveragePoint {
  uint64_t steps, cells;
  float closest;  // studs
};

struct Coverage {
  uint64_t rollouts = 0, idleRollouts = 0;  // idle: since the last new cell
  uint64_t singletons = 0;                  // cells that only their finder passed through
  std::vector<CoveragePoint> curve;         // points at doubling step counts, then at the end
};

// Upper bounds (97.5 %) after Good and Turing. Of the cells that n rollouts found, f were visited
// by one rollout only, and g by two. The next rollout finds a new cell with a probability of about
// f / n and a variance of (f + 2 g) / n^2. g is taken as f / 2, which is too high where finds
// become rarer. The bound is (f + 1.96 sqrt(2 f)) / n, or 3.69 / n if f is 0. As many rollouts
// again thus find about f new cells. The bounds assume that rollouts are drawn as before. They do
// not cover trajectories that need finer cells or rarer actions.
float newCellChance(const Coverage& t);    // [0, 1]
float newCellsIfTwice(const Coverage& t);  // new cells in as many rollouts again / cells found

// A search is saturated if searching as long again would find almost nothing new.
constexpr float kSaturated = 0.05f;      // threshold of newCellsIfTwice
constexpr uint64_t kMinRollouts = 4096;  // needed before a search counts as saturated
bool saturated(const Coverage& t);

// Notes the coverage of a search between rounds.
class CoverageLog {
 public:
  void note(const Search& search);
  // Must be called once, at the end of the search.
  Coverage finish(const Search& search);

 private:
  std::vector<CoveragePoint> points_;
  uint64_t next_ = 0;  // steps
};

void fillEvidence(schema::SearchEvidence::Builder record, const Coverage& t);

}  // namespace obby::solve
