// Faults of recorders: noisy positions, missing frames, frames at uneven times, and inputs that are
// late or rounded to a few directions.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "calibrate/track.h"

namespace obby::test {

struct Faults {
  float noise = 0;          // amplitude of position noise per axis, studs
  float dropped = 0;        // share of frames that are missing
  double jitter = 0;        // seconds by which a frame may be early or late
  uint32_t late = 0;        // frames between an input and its effect
  uint32_t directions = 0;  // number of possible directions of an input; 0: any
};

namespace detail {

inline Vec3 mixed(Vec3 a, Vec3 b, float share) { return a + (b - a) * share; }

// A moment between two frames: the index of the first one, and the share of the time to the next.
struct Moment {
  size_t frame;
  float share;
};

inline Moment momentAt(const std::vector<calibrate::Frame>& frames, double time) {
  size_t i = 0;
  while (i + 2 < frames.size() && frames[i + 1].time <= time) ++i;
  const double from = frames[i].time, to = frames[i + 1].time;
  return {i, float(std::clamp((time - from) / (to - from), 0.0, 1.0))};
}

// Returns the player at this time. Inputs, facing and state are those of the frame before.
inline calibrate::Frame frameAt(const std::vector<calibrate::Frame>& frames, double time) {
  const Moment m = momentAt(frames, time);
  const calibrate::Frame &a = frames[m.frame], &b = frames[m.frame + 1];
  calibrate::Frame out = m.share < 1 ? a : b;
  out.time = time;
  out.position = mixed(a.position, b.position, m.share);
  out.velocity = mixed(a.velocity, b.velocity, m.share);
  return out;
}

inline void addPoses(const calibrate::Track& from, double time, calibrate::Track& to) {
  const Moment m = momentAt(from.frames, time);
  for (size_t i = 0; i < from.shown.size(); ++i) {
    const calibrate::PartPose &a = from.pose(m.frame, i), &b = from.pose(m.frame + 1, i);
    to.poses.push_back(
        {mixed(a.position, b.position, m.share), m.share < 0.5f ? a.rotation : b.rotation});
  }
}

inline Vec3 roundedTo(Vec3 move, uint32_t directions) {
  if (move.x == 0 && move.z == 0) return move;
  const double part = 2 * std::numbers::pi / directions;
  const double angle = part * std::round(std::atan2(double(move.x), double(move.z)) / part);
  const double size = std::hypot(double(move.x), double(move.z));
  return {float(size * std::sin(angle)), 0, float(size * std::cos(angle))};
}

}  // namespace detail

// Returns a recording whose velocities are older than its positions by this share of a frame.
inline calibrate::Track withLateVelocities(const calibrate::Track& track, float share) {
  calibrate::Track out = track;
  for (size_t i = 1; i < track.frames.size(); ++i)
    out.frames[i].velocity =
        detail::mixed(track.frames[i].velocity, track.frames[i - 1].velocity, share);
  return out;
}

// Returns the recording that a recorder with these faults would make.
inline calibrate::Track spoiled(const calibrate::Track& track, const Faults& faults,
                                uint64_t seed) {
  Random random(seed, 0x5b01);
  const auto between = [&] { return 2 * random.unit() - 1; };
  calibrate::Track out = track;
  out.frames.clear();
  out.poses.clear();
  const auto& from = track.frames;
  for (size_t i = 0; i < from.size(); ++i) {
    const bool end = i == 0 || i + 1 == from.size();
    if (random.unit() < faults.dropped && !end) continue;
    const double shift = end ? 0 : faults.jitter * double(between());
    calibrate::Frame f = detail::frameAt(from, from[i].time + shift);
    // The frame takes the input from `late` frames later. So an input's effect shows `late` frames
    // after the input.
    const double late = faults.late * (from[1].time - from[0].time);
    const calibrate::Frame input = detail::frameAt(from, std::min(f.time + late, from.back().time));
    f.move = input.move;
    f.jump = input.jump;
    if (faults.directions > 0) f.move = detail::roundedTo(f.move, faults.directions);
    f.position += Vec3{between(), between(), between()} * faults.noise;
    detail::addPoses(track, f.time, out);
    out.frames.push_back(f);
  }
  return out;
}

}  // namespace obby::test
