#include "views/parts_in_sight.h"

#include <utility>

#include "views/view_frame.h"

namespace obby::bench {

namespace {

static_assert(policy::kMoments == 2);
constexpr policy::Moments kThen = 2;  // the second moment only

void put(PartInSight& part, PartNumber at, Vec3 v, float half) {
  part.features[size_t(at)] = policy::squashed(v.x, half);
  part.features[size_t(at) + 1] = policy::squashed(v.y, half);
  part.features[size_t(at) + 2] = policy::squashed(v.z, half);
}

// Collects parts in the order in which they are seen.
class Gatherer {
 public:
  Gatherer(const Params& params, const policy::Frame& frame)
      : axes_{frame.forward, frame.right, {0, 1, 0}}, middle_{0, 0.5f * params.bodyTop, 0} {
    parts_.reserve(64);
  }

  // A part that changes is seen once for each moment, in direct succession.
  void see(const policy::Sight& sight) {
    if (sight.moments == kThen && sight.collider == last_.collider) {
      PartInSight& part = parts_.back();
      const Vec3 moved = sight.solid.center - last_.solid.center;
      put(part, kPartMoved, toLocal(axes_, moved), kFastPart);
      part.features[kPartThere] = kStays;
      return;
    }
    last_ = sight;
    parts_.push_back(partOf(sight));
  }

  std::vector<PartInSight> take() { return std::move(parts_); }

 private:
  PartInSight partOf(const policy::Sight& sight) const {
    const policy::Solid solid = along(axes_, middle_, sight.solid);
    const Box box = boundsOf(Pose{solid.center, solid.axes}, solid.shape.half);
    const Vec3 nearest = min(max(Vec3{}, box.lo), box.hi);
    PartInSight part;
    part.distance = length(nearest);
    put(part, kPartCenter, solid.center, kFarPart);
    put(part, kPartHalf, (box.hi - box.lo) * 0.5f, kLargePart);
    put(part, kPartNearest, nearest, kNearPart);
    part.features[sight.kind == policy::kDanger ? kPartIsDanger : kPartIsFloor] = 1;
    part.features[kPartThere] = sight.moments == policy::kAlways ? kStays
                                : sight.moments == kThen         ? kComes
                                                                 : kGoes;
    return part;
  }

  const Mat3 axes_;
  const Vec3 middle_;  // the body's middle, relative to the feet
  policy::Sight last_{};
  std::vector<PartInSight> parts_;
};

}  // namespace

std::vector<PartInSight> partsInSight(const policy::Scene& scene, const sim::World& world,
                                      const sim::RigidBody* bodies, Turns ahead) {
  Gatherer gatherer(scene.level.params, policy::Frame(ahead));
  policy::lookAround(scene, world, bodies,
                     [&](const policy::Sight& sight) { gatherer.see(sight); });
  return gatherer.take();
}

}  // namespace obby::bench
