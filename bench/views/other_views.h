// Observations other than policy::observe(), for a comparison (bench_observation). Each fills the
// same kInputs in the same frame. The player's state and the nearest dynamic body are the same.
// Other features replace the maps, with policy::kEmptyInput where nothing is visible. All are
// derived from policy::lookAround(), now and 0.4 s later. They run on the CPU only, and no policy
// file uses them.
#pragma once

#include "policy/policy.h"
#include "views/parts_in_sight.h"

namespace obby::bench {

constexpr int kViewInputs = policy::kMaps * policy::kPoints;  // inputs that replace the maps

// Rays from the player's eye: one straight down, then for each elevation one in each direction of
// the maps' points. Those that look down meet level ground 1.5, 4.3 and 9.2 studs away.
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

// Observes, for each ray, the closeness of the nearest floor and of the nearest danger, and the
// changes of both a moment later. Closeness is 1 at the eye, and 0 at kRayReach and beyond. Dangers
// are as wide as in the maps. A danger behind a floor is hidden.
Turns rays(const policy::Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
           float* inputs);

constexpr int kListedParts = 16;
constexpr int partInput(int place, PartNumber number) {
  return policy::kMapsAt + place * kPartNumbers + number;
}

// Observes the features of the nearest parts (parts_in_sight.h), nearest first.
Turns nearestParts(const policy::Scene& scene, const sim::World& world,
                   const sim::RigidBody* bodies, float* inputs);

// Observes all parts as an unordered set. Each part has kViewInputs random features of its numbers
// (parts_in_sight.h), scaled down with distance. Each input is a feature's maximum over the parts.
// An encoder with learned features, as in set networks and attention, would need another network.
Turns partSet(const policy::Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
              float* inputs);

}  // namespace obby::bench
