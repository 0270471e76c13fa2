// Other ways to see than policy::observe(), to learn what they are worth (bench_observation). Each
// fills the same kInputs in the same frame: the player's state and the nearest loose body as there,
// and in the place of the maps something else, which is policy::kEmptyInput where nothing is in
// sight. All are of what policy::lookAround() shows, now and 0.4 s later. For the CPU alone; no
// policy file is of these.
#pragma once

#include "policy/policy.h"
#include "views/parts_in_sight.h"

namespace obby::bench {

constexpr int kViewInputs = policy::kMaps * policy::kPoints;  // in the place of the maps

// Rays from the player's eye: straight down, then for each elevation one in each direction of the
// maps' points. Those that look down meet the ground that the feet are on 1.5, 4.3 and 9.2 studs
// away.
constexpr float kRayDegrees[] = {-63, -35, -18, 0, 25};  // elevations
constexpr int kElevations = int(sizeof kRayDegrees / sizeof kRayDegrees[0]);
constexpr int kRays = 1 + kElevations * policy::kDirections;
constexpr float kEyeHeight = 3;  // studs above the feet
constexpr float kRayReach = 16;  // studs

constexpr int rayAt(int elevation, int direction) {
  return 1 + elevation * policy::kDirections + direction;
}
constexpr int rayInput(int moment, policy::Kind kind, int ray) {
  return policy::kMapsAt + (moment * policy::kKinds + kind) * kRays + ray;
}

// Of each ray how close the nearest floor is, and how close the nearest danger: from 1 at the eye
// down to 0 at kRayReach and beyond; and by how much either will have changed. Dangers are as wide
// as in the maps, and not shown behind a floor.
Turns rays(const policy::Scene& scene, const sim::World& world, const sim::LooseBody* loose,
           float* inputs);

constexpr int kListedParts = 16;
constexpr int partInput(int place, PartNumber number) {
  return policy::kMapsAt + place * kPartNumbers + number;
}

// The nearest parts, the nearest first, as parts_in_sight.h tells them.
Turns nearestParts(const policy::Scene& scene, const sim::World& world, const sim::LooseBody* loose,
                   float* inputs);

// All parts, as a set: of each, kViewInputs random features of how parts_in_sight.h tells it, less
// the farther away it is; and of each feature the most that any part has of it. So their order does
// not show. An encoder whose features are learned, as the networks for sets and attention have it,
// would need a network of another form.
Turns partSet(const policy::Scene& scene, const sim::World& world, const sim::LooseBody* loose,
              float* inputs);

}  // namespace obby::bench
