// Builds the table of the parts near a place, once per level and shared by all worlds. Host only.
#pragma once

#include <vector>

#include "policy/surroundings_view.h"

namespace obby::policy {

class Surroundings {
 public:
  // Parts are listed up to `reach` studs sideways. Parts that neither support nor harm are left
  // out, and so are dynamic ones, which may be anywhere. Squares are 8 studs wide. They are wider
  // in huge levels, and where the lists would have more than 2^24 entries together.
  Surroundings(const level::LevelView& level, float reach);
  SurroundingsView view() const;  // valid while this object lives at its address

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
