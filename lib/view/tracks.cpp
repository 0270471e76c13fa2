// Tabulates level::moverPose.
#include "view/tracks.h"

#include <numeric>
#include <vector>

#include "level/rotation.h"

namespace obby::view {
namespace {

constexpr uint32_t kLeastOfRound = 12;  // samples; fewer might show a motion as none

// The coarsest that a round bears, of `stride` and its halves. Where the round repeats it must
// divide it, or the seam would stutter.
uint32_t fitting(uint64_t period, bool repeats, uint32_t stride) {
  while (stride > 1 && (period / stride < kLeastOfRound || (repeats && period % stride != 0))) {
    stride /= 2;
  }
  return stride;
}

// How many ticks to tabulate, and whether they repeat.
void setExtent(Track& track, const level::Mover& mover, uint32_t ticks, uint32_t stride) {
  const uint64_t spin = mover.spinCount == 0 ? 1 : mover.spinCount;
  const uint64_t period = mover.once ? (spin == 1 ? mover.keyCount : UINT64_MAX)
                                     : std::lcm(uint64_t(mover.keyCount), spin);
  if (period <= ticks) {
    track.loopFrom = mover.once ? -1 : 0;
    track.stride = fitting(period, !mover.once, stride);
    track.count = uint32_t((period + track.stride - 1) / track.stride);
    if (mover.once) track.count += 1;
  } else {
    track.stride = stride;
    track.count = (ticks + stride - 1) / stride + 1;  // up to the last tick, if not beyond
    track.cut = true;
  }
}

constexpr float kSame = 1e-4f;  // studs, and of a unit vector: less is rounding

bool samePlace(Vec3 a, Vec3 b) { return length(a - b) <= kSame; }

bool sameRotation(const Mat3& a, const Mat3& b) {
  return samePlace(a.x, b.x) && samePlace(a.y, b.y) && samePlace(a.z, b.z);
}

// What stays as it is may still differ from what the level has: the keys of a motion say where a
// part is, whatever its own pose is.
Track trackOf(const level::Collider& collider, const level::Mover& mover, uint32_t ticks,
              uint32_t stride) {
  Track track;
  track.part = collider.part;
  track.triggered = mover.trigger != level::kNone;
  setExtent(track, mover, ticks, stride);
  const Pose& own = collider.pose;
  bool moves = false, turns = false;
  for (uint32_t i = 0; i < track.count; ++i) {
    const Pose pose = level::moverPose(mover, i * track.stride);
    moves = moves || !samePlace(pose.position, own.position);
    turns = turns || !sameRotation(pose.rotation, own.rotation);
    track.add(pose.position, toQuat(pose.rotation));
  }
  if (!moves) track.positions.clear();
  if (!turns) track.rotations.clear();
  return track;
}

}  // namespace

void forTracks(const level::LevelView& level, uint32_t ticks, uint32_t stride,
               const std::function<void(const Track&)>& visit) {
  std::vector<bool> done(level.moverCount, false);  // hulls of one part share its mover
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    const level::Collider& collider = level.colliders[i];
    if (collider.mover == level::kNone || done[collider.mover]) continue;
    done[collider.mover] = true;
    visit(trackOf(collider, level.movers[collider.mover], ticks, stride));
  }
}

}  // namespace obby::view
