// A region of a record as the verifier reads it: a box, or a part to be touched. That a limb
// touches a part is physics, and the simulator's to say.
#pragma once

#include <cstdint>
#include <span>

#include "level/collider_runs.h"
#include "level/level_view.h"
#include "sim/loose.h"
#include "sim/world.h"
#include "solve/verify/box_region.h"

namespace obby::solve {

// Where the feet are.
Point feetOf(const sim::World& world);

class Place {
 public:
  // The parts that it names are resolved; `runs` of the level. `arrive`: what reaching a solid part
  // means.
  Place(schema::Region::Reader region, level::ColliderRuns& runs, schema::Arrive arrive,
        const level::LevelView& level);

  // Is the player there now?
  bool holds(const level::LevelView& level, const sim::World& world,
             std::span<const sim::LooseBody> loose) const;
  // Likewise, or was the player in the box on the straight way from where the tick began, in
  // `before`? A teleport has no way, and parts are not asked on it.
  bool isEntered(const level::LevelView& level, const sim::World& before, const sim::World& world,
                 std::span<const sim::LooseBody> loose) const;

 private:
  BoxRegion box_;
  bool touch_;             // of a part; else the box counts
  bool stand_ = false;     // something has to hold the player, with the feet in the box
  double lowest_ = -1e30;  // of those feet
  level::ColliderRun colliders_;
};

}  // namespace obby::solve
