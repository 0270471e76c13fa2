// Makes the table of which parts are near a place. Once a level, shared by all worlds. Host only.
#pragma once

#include <vector>

#include "policy/surroundings_view.h"

namespace obby::policy {

class Surroundings {
 public:
  // `reach`: studs sideways to which parts are listed. Parts that neither bear nor harm are left
  // out, and loose ones: they may be anywhere.
  Surroundings(const level::LevelView& level, float reach);
  SurroundingsView view() const;  // valid while this object lives and stays where it is

 private:
  struct Square {
    int32_t x0, x1, z0, z1;
  };
  Square squareOf(const Box& box, float reach) const;

  Vec3 origin_{};
  float cell_ = 8;
  int32_t nx_ = 0, nz_ = 0;
  std::vector<uint32_t> starts_, entries_;
};

}  // namespace obby::policy
