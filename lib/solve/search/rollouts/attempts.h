// Records how attempts ended: counts by outcome and part, and a varied sample of them to show.
#pragma once

#include <cstdint>
#include <map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "solve/search/archive/archive.h"

namespace obby::solve {

// The place and outcome of an attempt's end.
struct AttemptEnd {
  Node node;
  Vec3 position;  // feet
  sim::Outcome outcome;
  uint32_t part;  // part that killed or hurt the player; if avoided, index in the query's avoid
                  // list; or kNone
};

struct EndCount {
  sim::Outcome outcome;
  uint32_t part;
  uint64_t count;
};

class Attempts {
 public:
  // Counts an attempt. Must be called in a fixed order, since the first of two ends of the same
  // kind is kept. Returns true if this end is kept to be shown.
  bool add(const AttemptEnd& end) {
    count(end.outcome, end.part, 1);
    return show(end);
  }
  // The two halves of add(). count() counts `count` attempts with this end, show() keeps one as a
  // sample.
  void count(sim::Outcome outcome, uint32_t part, uint64_t count) {
    counts_[{outcome, part}] += count;
  }
  bool show(const AttemptEnd& end);

  // Returns the counts, most frequent first; ties by outcome, then part.
  std::vector<EndCount> counts() const;

  // Returns the last `count` failures of a new place or outcome, newest first.
  std::vector<AttemptEnd> newestFailures(size_t count) const;

  // Returns at most `count` attempts that differ in place and outcome, chosen to be far apart. The
  // first is the one nearest to `near`.
  std::vector<AttemptEnd> sample(size_t count, Vec3 near) const;

 private:
  std::map<std::pair<sim::Outcome, uint32_t>, uint64_t> counts_;
  std::unordered_set<uint64_t> kinds_;  // place and outcome
  std::vector<AttemptEnd> ends_;
};

}  // namespace obby::solve
