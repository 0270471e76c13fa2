// Tabulates level::moverPose.
#include "view/tracks.h"

#include <numeric>
#include <vector>

#include "level/rotation.h"

namespace obby::view {
namespace {

// Min samples per period; with fewer, a motion might disappear.
constexpr uint32_t kMinOfRound = 12;

// Returns the largest stride that a period allows, by halving `stride`. If the motion repeats, the
// stride must divide the period, or playback would stutter at the seam.
uint32_t fitting(uint64_t period, bool repeats, uint32_t stride) {
  while (stride > 1 && (period / stride < kMinOfRound || (repeats && period % stride != 0))) {
    stride /= 2;
  }
  return stride;
}

// Sets how many ticks to tabulate, and whether they repeat.
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
    track.count = (ticks + stride - 1) / stride + 1;  // includes the last tick
    track.cut = true;
  }
}

constexpr float kSame = 1e-4f;  // studs, or units of a unit vector: rounding error

bool samePlace(Vec3 a, Vec3 b) { return length(a - b) <= kSame; }

bool sameRotation(const Mat3& a, const Mat3& b) {
  return samePlace(a.x, b.x) && samePlace(a.y, b.y) && samePlace(a.z, b.z);
}

// A constant track may still differ from the level, since motion keys override a part's own pose.
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
