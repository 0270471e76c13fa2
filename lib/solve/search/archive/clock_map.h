// Builds the map of where the level's clock matters, and the bins of the other clocks. Host only.
#pragma once

#include <vector>

#include "solve/search/archive/clock_view.h"

namespace obby::solve {

class ClockMap {
 public:
  // `reach`: studs around a part within which its clock matters.
  ClockMap(const level::LevelView& level, float reach);
  ClockView view() const;  // valid while this object lives

 private:
  struct Clocked {
    Box box;
    uint32_t period;
  };
  void layOut(const std::vector<Clocked>& parts);
  void mark(const Clocked& part);
  void findBins(const level::LevelView& level);

  std::vector<uint32_t> periods_;
  std::vector<uint32_t> bins_;
  Vec3 origin_;
  float cell_ = 8;
  int32_t nx_ = 0, ny_ = 0, nz_ = 0;
};

// Returns the ticks after which clocks of both periods coincide again; 0 if that is too long.
uint32_t jointPeriod(uint32_t a, uint32_t b);

}  // namespace obby::solve
