// How thorough a search was that found nothing: what it covered over its steps, and how likely
// another rollout is to find something new.
#pragma once

#include <cstdint>
#include <vector>

#include "schema/obby.capnp.h"
#include "solve/search/search.h"

namespace obby::solve {

// What a search had covered after a number of steps.
struct CoveragePoint {
  uint64_t steps, cells;
  float closest;  // studs
};

struct Thoroughness {
  uint64_t rollouts = 0, idleRollouts = 0;  // idle: since the last new cell
  uint64_t singletons = 0;                  // cells that only their finder passed through
  std::vector<CoveragePoint> coverage;      // at doubling counts of steps; the end last
};

// Bounds (97.5 %) after Good and Turing: of n rollouts that found f cells which no other passed
// through, the next finds a new one with a chance of about f / n, with a variance of (f + 2 g) /
// n^2 where g cells were passed through by two. g is taken as f / 2, which it is below where finds
// become rarer: at most (f + 1.96 sqrt(2 f)) / n; where f is 0, 3.69 / n. So as many rollouts again
// find about f new cells. Supposes that they are drawn as before, and says nothing of ways that
// need finer cells or rarer actions.
float newCellChance(const Thoroughness& t);  // [0, 1]
float newCellsIfTwice(
    const Thoroughness& t);  // as a share of the cells found, if searched as long again

// Searching as long again would find next to nothing.
constexpr float kSaturated = 0.05f;        // of newCellsIfTwice
constexpr uint64_t kLeastRollouts = 4096;  // before anything is said
bool saturated(const Thoroughness& t);

// Watches a search between rounds.
class CoverageLog {
 public:
  void note(const Search& search);
  // To be called once, at the end of the search.
  Thoroughness finish(const Search& search);

 private:
  std::vector<CoveragePoint> points_;
  uint64_t next_ = 0;  // steps
};

void fillEvidence(schema::SearchEvidence::Builder record, const Thoroughness& t);

}  // namespace obby::solve
