// How attempts ended: counts by outcome and part, and a varied sample of them to show.
#pragma once

#include <cstdint>
#include <map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "solve/search/archive/archive.h"

namespace obby::solve {

// Where and how one attempt ended.
struct AttemptEnd {
  Node way;
  Vec3 position;  // feet
  sim::Outcome outcome;
  uint32_t part;  // what killed or hurt the player, of avoided: the query's avoid; or kNone
};

struct EndCount {
  sim::Outcome outcome;
  uint32_t part;
  uint64_t count;
};

class Attempts {
 public:
  // To be called in a fixed order: of two attempts with the same kind of end the first is kept.
  // True: this one may be shown.
  bool add(const AttemptEnd& end) {
    count(end.outcome, end.part, 1);
    return show(end);
  }
  // The two halves of that: `count` attempts that ended so, and one that may be shown.
  void count(sim::Outcome outcome, uint32_t part, uint64_t count) {
    counts_[{outcome, part}] += count;
  }
  bool show(const AttemptEnd& end);

  // Most frequent first; ties by outcome, then part.
  std::vector<EndCount> counts() const;

  // The last `count` that failed in a way or at a place that none had before, the newest first.
  std::vector<AttemptEnd> newestFailures(size_t count) const;

  // At most `count` attempts that differ in place and outcome, chosen to be far apart; the one
  // nearest to `near` first.
  std::vector<AttemptEnd> sample(size_t count, Vec3 near) const;

 private:
  std::map<std::pair<sim::Outcome, uint32_t>, uint64_t> counts_;
  std::unordered_set<uint64_t> kinds_;  // place and outcome
  std::vector<AttemptEnd> ends_;
};

}  // namespace obby::solve
