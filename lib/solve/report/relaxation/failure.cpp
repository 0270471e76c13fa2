#include "solve/report/relaxation/failure.h"

namespace obby::solve {

void Footprints::note(const std::vector<Vec3>& places) {
  for (const Vec3 at : places) {
    places_.emplace(floorToInt(at.x), floorToInt(at.y * 4), floorToInt(at.z));
  }
}

std::vector<Vec3> Footprints::places() const {
  std::vector<Vec3> all;
  for (const auto& [x, y, z] : places_) {
    all.push_back({float(x) + 0.5f, float(y) * 0.25f, float(z) + 0.5f});
  }
  return all;
}

}  // namespace obby::solve
