#include "calibrate/surroundings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "level/rotation.h"
#include "level/select_parts.h"

namespace obby::calibrate {

namespace {

constexpr uint32_t kSamples = 48;       // max frames compared to find the clock
constexpr float kStray = 0.5f;          // studs: a larger distance is not noise but another motion
constexpr float kRestingSpeed = 0.05f;  // studs/s: slower bodies are at rest
constexpr float kFar = 10;              // studs from a body at which there is no contact

// Returns the first collider of the part, or null if it has none.
const level::Collider* colliderOf(const level::LevelView& level, uint32_t part) {
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    const level::Collider& c = level.colliders[i];
    if (c.part == part) return &c;
  }
  return nullptr;
}

// Returns the part's mover if the level clock drives it, not a touch.
const level::Mover* clockworkOf(const level::LevelView& level, uint32_t part) {
  const level::Collider* c = colliderOf(level, part);
  if (!c || c->mover == level::kNone) return nullptr;
  const level::Mover& m = level.movers[c->mover];
  return m.trigger == level::kNone ? &m : nullptr;
}

// Sums over the centre and two axes, so that rotation counts as well.
float squaredOff(const PartPose& shown, const Pose& pose) {
  const Mat3 axes = toMat3(shown.rotation);
  const Vec3 moved = shown.position - pose.position;
  const Vec3 one = axes.x - pose.rotation.x, two = axes.y - pose.rotation.y;
  return dot(moved, moved) + dot(one, one) + dot(two, two);
}

// Returns the mean square over samples, or the max float early once it exceeds `enough`.
float squaredOff(const Track& track, size_t part, const level::Mover& mover, const Params& params,
                 double phase, float enough) {
  const size_t step = std::max<size_t>(1, track.frames.size() / kSamples);
  float sum = 0;
  size_t count = 0;
  for (size_t f = 0; f < track.frames.size(); f += step, ++count) {
    sum += squaredOff(track.pose(f, part),
                      level::moverPose(mover, wholeTicks(phase + track.frames[f].time, params)));
    if (sum > enough * float(kSamples * 2)) return std::numeric_limits<float>::max();
  }
  return sum / float(count);
}

struct Shown {
  size_t index;  // into Track::shown
  const level::Mover* mover;
};

std::vector<Shown> clockworks(const Track& track, const level::LevelView& level) {
  std::vector<Shown> out;
  for (size_t i = 0; i < track.parts.size(); ++i) {
    if (const level::Mover* m = clockworkOf(level, track.parts[i])) out.push_back({i, m});
  }
  return out;
}

// Returns the clock phase that fits the recorded motion best, seconds. `period` is in ticks.
double phaseOf(const Track& track, const level::LevelView& level, uint32_t period) {
  const std::vector<Shown> moving = clockworks(track, level);
  if (moving.empty()) return 0;
  const uint32_t rate = level.params.controlRate, longest = kLongestClock * rate;
  const uint32_t end = period == 0 ? longest : std::min(period, longest);
  double best = 0;
  float min = std::numeric_limits<float>::max();
  for (uint32_t tick = 0; tick < end; ++tick) {
    const double phase = double(tick) / rate;
    float sum = 0;
    for (const Shown& s : moving) {
      sum += squaredOff(track, s.index, *s.mover, level.params, phase, min);
      if (sum >= min) break;
    }
    if (sum >= min) continue;
    min = sum;
    best = phase;
  }
  return best;
}

// Returns the body of a recorded part, or kNoBody. It searches the bodies, which are few. It runs
// for each recorded part at each tick before a window, and a place has thousands of colliders.
uint8_t bodyOf(const level::LevelView& level, uint32_t part) {
  for (uint32_t i = 0; i < level.bodyCount; ++i) {
    if (level.colliders[level.bodies[i].firstCollider].part == part) return uint8_t(i);
  }
  return level::kNoBody;
}

// Returns the turn from one rotation to another, in radians about the world axes.
Vec3 turnBetween(Quat from, Quat to) { return rotationVector(toMat3(to) * inverse(toMat3(from))); }

}  // namespace

Status place(Track& track, schema::Level::Reader record, const level::Level& level) {
  track.parts.clear();
  level::PartIndex parts(record);
  for (size_t i = 0; i < track.shown.size(); ++i) {
    const auto part = level::matchPart(parts, track.shown[i]);
    if (!part) {
      Error error = part.error();
      error.path = fmt::format("parts[{}]", i);
      return error;
    }
    track.parts.push_back(*part);
  }
  track.phase = phaseOf(track, level.view(), level.motionPeriod());
  return {};
}

std::vector<Stray> straysOf(const Track& track, const level::LevelView& level) {
  std::vector<Stray> out;
  for (const Shown& s : clockworks(track, level)) {
    const float off = std::sqrt(squaredOff(track, s.index, *s.mover, level.params, track.phase,
                                           std::numeric_limits<float>::infinity()));
    if (off > kStray) out.push_back({track.shown[s.index], track.parts[s.index], off});
  }
  return out;
}

bool showsBodies(const Track& track, const level::LevelView& level) {
  std::vector<bool> matters(level.bodyCount);
  for (uint32_t i = 0; i < level.bodyCount; ++i) {
    const level::DynamicBody& body = level.bodies[i];
    const Vec3 center = body.position + toMat3(body.rotation) * body.center;
    matters[i] = std::any_of(track.frames.begin(), track.frames.end(), [&](const Frame& f) {
      return length(f.position - center) < body.radius + kFar;
    });
  }
  for (const uint32_t part : track.parts) {
    const uint8_t body = bodyOf(level, part);
    if (body != level::kNoBody) matters[body] = false;
  }
  return std::none_of(matters.begin(), matters.end(), [](bool does) { return does; });
}

bool showBodies(const Track& track, uint32_t frame, const level::LevelView& level,
                std::vector<sim::RigidBody>& bodies) {
  const uint32_t before = frame > 0 ? frame - 1 : 0;
  const uint32_t after = std::min(frame + 1, uint32_t(track.frames.size()) - 1);
  const float rate = float(1 / (track.frames[after].time - track.frames[before].time));
  bool moves = false;
  for (size_t i = 0; i < track.parts.size(); ++i) {
    const uint8_t index = bodyOf(level, track.parts[i]);
    if (index == level::kNoBody) continue;
    const Vec3 center = level.bodies[index].center;
    const auto centerAt = [&](uint32_t f) {
      return track.pose(f, i).position + toMat3(track.pose(f, i).rotation) * center;
    };
    sim::RigidBody& body = bodies[index];
    body.position = centerAt(frame);
    body.rotation = track.pose(frame, i).rotation;
    body.velocity = (centerAt(after) - centerAt(before)) * rate;
    body.spin = turnBetween(track.pose(before, i).rotation, track.pose(after, i).rotation) * rate;
    const bool rests = length(body.velocity) < kRestingSpeed && length(body.spin) < kRestingSpeed;
    if (rests) body.velocity = body.spin = {};
    body.state = rests ? sim::RigidBodyState::asleep : sim::RigidBodyState::awake;
    moves |= !rests;
  }
  return moves;
}

}  // namespace obby::calibrate
