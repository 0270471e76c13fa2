// A region of a record as the verifier reads it: a box, or a part to be touched. The simulator
// decides if a limb touches a part, since that is physics.
#pragma once

#include <cstdint>
#include <span>

#include "level/collider_runs.h"
#include "level/level_view.h"
#include "sim/rigid_body.h"
#include "sim/world.h"
#include "solve/verify/box_region.h"

namespace obby::solve {

// Returns the position of the feet.
Point feetOf(const sim::World& world);

class Place {
 public:
  // The region must have its parts resolved, and `runs` must belong to the level. `arrive` decides
  // when a player has reached a solid part.
  Place(schema::Region::Reader region, level::ColliderRuns& runs, schema::Arrive arrive,
        const level::LevelView& level);

  // Returns true if the player is there now.
  bool holds(const level::LevelView& level, const sim::World& world,
             std::span<const sim::RigidBody> bodies) const;
  // Returns true if the player is there now, or was in the box on the straight path since `before`,
  // the start of the tick. After a teleport, or if a part must be touched, only the place at the
  // end of the tick counts.
  bool isEntered(const level::LevelView& level, const sim::World& before, const sim::World& world,
                 std::span<const sim::RigidBody> bodies) const;

 private:
  BoxRegion box_;
  bool touch_;             // a part has to be touched; else the box counts
  bool stand_ = false;     // something has to hold the player, with the feet in the box
  double lowest_ = -1e30;  // min height of those feet
  level::ColliderRun colliders_;
};

}  // namespace obby::solve
