// The distinct solutions of a query, shortest first. Of several solutions that are the same by
// `identity`, only the shortest is kept.
#pragma once

#include <functional>
#include <vector>

#include "solve/search/solution_identity.h"

namespace obby::solve {

// Solutions that take the same route.
struct RouteTally {
  std::vector<int32_t> route;  // directRouteOf()
  uint64_t count = 0;
  uint32_t ticks = 0;  // length of the shortest
};

class Solutions {
 public:
  enum class Offer { kept, known, refused };

  // The problem must outlive this object.
  Solutions(const Problem& problem, const SolutionIdentity& identity)
      : problem_(problem), identity_(identity) {}

  // Keeps a solution that is distinct from all others, or shorter than the ones that are the same,
  // which it replaces. Only these solutions are passed to `accept`, which may be empty.
  Offer offer(Trajectory p, const std::function<bool(const Trajectory&)>& accept);

  size_t count() const { return solutions_.size(); }
  std::vector<Trajectory> all() const;  // sorted by ticks, then jumps
  // Returns the solutions by route: the most frequent route first, ties by length.
  std::vector<RouteTally> routes() const;

 private:
  const Problem& problem_;
  const SolutionIdentity& identity_;
  std::vector<Solution> solutions_;
};

}  // namespace obby::solve
