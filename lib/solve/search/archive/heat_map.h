// A coarse map of where a search has been, for people to look at. Its cubes grow with the search.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "math/vec.h"
#include "schema/obby.capnp.h"

namespace obby::solve {

class HeatMap {
 public:
  // Adds the positions of further cells of a search (Search::places).
  void note(const std::vector<Vec3>& places);
  bool empty() const { return cubes_.empty(); }
  void fill(schema::HeatMap::Builder record) const;  // in order of x, y, z

 private:
  using Key = std::tuple<int32_t, int32_t, int32_t>;
  struct Cube {
    Vec3 feet;
    uint32_t cells = 0;
  };

  void add(Vec3 feet, uint32_t cells);
  void coarsen();

  float size_ = 2;  // studs
  std::map<Key, Cube> cubes_;
};

}  // namespace obby::solve
