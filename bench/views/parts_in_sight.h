// The features of each visible part.
#pragma once

#include <array>
#include <vector>

#include "policy/observation.h"

namespace obby::bench {

// Values in the player's frame from the body's middle: forward, right, up. All are of order 1. A
// rotation of the part about its own middle does not show.
enum PartNumber : int {
  kPartCenter = 0,
  kPartHalf = 3,     // half extents of the part's box along the frame
  kPartNearest = 6,  // nearest point of that box
  kPartIsFloor = 9,
  kPartIsDanger = 10,
  kPartMoved = 11,  // displacement of the part's centre a moment later
  kPartThere = 14,  // kStays, kGoes or kComes
  kPartNumbers = 15
};
// Present now and a moment later; now only; later only.
constexpr float kStays = 1, kGoes = 0.5f, kComes = -0.5f;

// Distances in studs that map to half of a feature's range.
constexpr float kFarPart = 8, kLargePart = 4, kNearPart = 4, kFastPart = 2;

struct PartInSight {
  float distance = 0;  // distance to the part's box, studs
  std::array<float, kPartNumbers> features{};

  // Orders by distance. Ties are decided by the features, so that the order of parts in the level
  // does not matter.
  friend bool operator<(const PartInSight& a, const PartInSight& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.features < b.features;
  }
};

// Returns the parts in the order of policy::lookAround(). `ahead`: direction of the frame;
// `bodies`: (level.bodyCount).
std::vector<PartInSight> partsInSight(const policy::Scene& scene, const sim::World& world,
                                      const sim::RigidBody* bodies, Turns ahead);

}  // namespace obby::bench
