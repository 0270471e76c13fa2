// The distinct solutions of a query, shortest first. Two solutions are distinct if one of them is
// somewhere kDistinct studs away from all of the other.
#pragma once

#include <vector>

#include "solve/playthrough.h"

namespace obby::solve {

constexpr float kDistinct = 4;  // studs

class Solutions {
 public:
  // Would this way change the set: distinct from all, or better than the one it resembles?
  bool wants(const Playthrough& p) const;
  // Adds it, in place of a worse one that it resembles.
  void add(Playthrough p);
  const std::vector<Playthrough>& all() const { return all_; }  // fewest ticks, then jumps, first

 private:
  size_t similar(const Playthrough& p) const;
  std::vector<Playthrough> all_;
};

// Is some point of either path farther than `distance` from every point of the other?
bool pathsDiffer(const std::vector<Vec3>& a, const std::vector<Vec3>& b, float distance);

}  // namespace obby::solve
