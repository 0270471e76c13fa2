// The solutions of a query that differ, shortest first: of those that are the same by `identity`
// the shortest is kept.
#pragma once

#include <functional>
#include <vector>

#include "solve/search/way_identity.h"

namespace obby::solve {

// Solutions that take the same route.
struct RouteTally {
  std::vector<int32_t> route;  // directRouteOf()
  uint64_t count = 0;
  uint32_t ticks = 0;  // of the shortest
};

class Solutions {
 public:
  enum class Offer { kept, known, refused };

  // The problem must outlive it.
  Solutions(const Problem& problem, const WayIdentity& identity)
      : problem_(problem), identity_(identity) {}

  // Keeps a way that is distinct from all, or better than all that it is the same as and whose
  // place it takes; those only are put to `accept`, which may be empty.
  Offer offer(Playthrough p, const std::function<bool(const Playthrough&)>& accept);

  size_t count() const { return ways_.size(); }
  std::vector<Playthrough> all() const;  // fewest ticks, then jumps, first
  // All solutions by route: most frequent, then shortest, first.
  std::vector<RouteTally> routes() const;

 private:
  const Problem& problem_;
  const WayIdentity& identity_;
  std::vector<Way> ways_;
};

}  // namespace obby::solve
