// Makes the table of which parts are near a place. Once a level, shared by all worlds. Host only.
#pragma once

#include <vector>

#include "policy/surroundings_view.h"

namespace obby::policy {

class Surroundings {
 public:
  // `reach`: studs sideways to which parts are listed. Parts that neither bear nor harm are left
  // out, and loose ones: they may be anywhere. Squares are of 8 studs; in huge levels, and where
  // their lists would have more than 2^24 entries together, of more.
  Surroundings(const level::LevelView& level, float reach);
  SurroundingsView view() const;  // valid while this object lives and stays where it is

 private:
  struct Square {
    int32_t x0, x1, z0, z1;
  };
  void divide(Vec3 extent, float cell);
  Square squareOf(const Box& b, float reach) const;
  uint64_t entriesOf(const level::LevelView& level, float reach) const;
  void fill(const level::LevelView& level, float reach);

  Vec3 origin_{};
  float cell_ = 8;
  int32_t nx_ = 0, nz_ = 0;
  std::vector<uint32_t> starts_, entries_;
};

}  // namespace obby::policy
