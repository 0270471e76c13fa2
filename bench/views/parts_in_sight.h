// Each part that is in sight, told in a few numbers.
#pragma once

#include <array>
#include <vector>

#include "policy/observation.h"

namespace obby::bench {

// In the player's frame, from the body's middle: forward, right, up. All of order 1. A turn about
// the part's own middle does not show.
enum PartNumber : int {
  kPartCenter = 0,
  kPartHalf = 3,     // extents of its box along the frame
  kPartNearest = 6,  // the point of that box which is nearest
  kPartIsFloor = 9,
  kPartIsDanger = 10,
  kPartMoved = 11,  // how far its centre will have moved a moment later
  kPartThere = 14,  // kStays, kGoes or kComes
  kPartNumbers = 15
};
// There now and a moment later; now only; later only.
constexpr float kStays = 1, kGoes = 0.5f, kComes = -0.5f;

// Distances, in studs, that half of a number's range is used up at.
constexpr float kFarPart = 8, kLargePart = 4, kNearPart = 4, kFastPart = 2;

struct PartInSight {
  float distance = 0;  // studs to its box
  std::array<float, kPartNumbers> told{};

  // Nearer ones first; whatever else differs decides between those that are equally near, so that
  // the level's order of parts does not.
  friend bool operator<(const PartInSight& a, const PartInSight& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.told < b.told;
  }
};

// As policy::lookAround() comes to them. `ahead`: where the frame looks; `loose`:
// (level.looseCount).
std::vector<PartInSight> partsInSight(const policy::Scene& scene, const sim::World& world,
                                      const sim::LooseBody* loose, Turns ahead);

}  // namespace obby::bench
