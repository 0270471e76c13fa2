// Tabulates level::moverPose.
#include "view/tracks.h"

#include <numeric>

#include "level/rotation.h"

namespace obby::view {
namespace {

// How many ticks to tabulate, and whether they repeat.
void setExtent(Track& track, const level::Mover& mover, uint32_t ticks, uint32_t stride) {
  const uint64_t spin = mover.spinCount == 0 ? 1 : mover.spinCount;
  const uint64_t period = mover.once ? (spin == 1 ? mover.keyCount : UINT64_MAX)
                                     : std::lcm(uint64_t(mover.keyCount), spin);
  if (period <= ticks) {
    track.loopFrom = mover.once ? -1 : 0;
    // A stride must divide the period, or the seam would stutter.
    track.stride = mover.once || period % stride == 0 ? stride : 1;
    track.count = uint32_t((period + track.stride - 1) / track.stride);
    if (mover.once) track.count += 1;
  } else {
    track.stride = stride;
    track.count = (ticks + stride - 1) / stride + 1;  // up to the last tick, if not beyond
  }
}

bool sameRotation(const Mat3& a, const Mat3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

Track trackOf(const level::Mover& mover, uint32_t part, uint32_t ticks, uint32_t stride) {
  Track track;
  track.part = part;
  track.triggered = mover.trigger != level::kNone;
  setExtent(track, mover, ticks, stride);
  const Pose first = level::moverPose(mover, 0);
  bool moves = false, turns = false;
  for (uint32_t i = 0; i < track.count; ++i) {
    const Pose pose = level::moverPose(mover, i * track.stride);
    moves = moves || !(pose.position == first.position);
    turns = turns || !sameRotation(pose.rotation, first.rotation);
    track.add(pose.position, toQuat(pose.rotation));
  }
  if (!moves) track.positions.clear();
  if (!turns) track.rotations.clear();
  return track;
}

}  // namespace

std::vector<Track> tracksOf(const level::LevelView& level, uint32_t ticks, uint32_t stride) {
  std::vector<Track> tracks;
  std::vector<bool> done(level.moverCount, false);  // hulls of one part share its mover
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    const level::Collider& collider = level.colliders[i];
    if (collider.mover == level::kNone || done[collider.mover]) continue;
    done[collider.mover] = true;
    tracks.push_back(trackOf(level.movers[collider.mover], collider.part, ticks, stride));
  }
  return tracks;
}

}  // namespace obby::view
