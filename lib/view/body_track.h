// Tracks of dynamic parts in a replay: parts that the player pushes, and parts that fall.
#pragma once

#include <cstdint>
#include <vector>

#include "level/level_view.h"
#include "sim/simulator.h"
#include "view/poses.h"

namespace obby::view {

// Poses of one part at some ticks. Between them, linear interpolation of position and rotation is
// accurate to kBodyMiss.
struct BodyTrack : Poses {
  uint32_t part = 0;
  std::vector<uint32_t> ticks;  // ticks of the samples since the start; ascending

  size_t bytes() const { return Poses::bytes() + ticks.size() * 4; }
};
constexpr float kBodyMiss = 2.5e-4f;  // studs, for any point of the part

// A pose that a body keeps from a tick on.
struct BodyStay {
  uint32_t tick;  // ticks since the trajectory's start
  Vec3 center;    // center of mass
  Quat rotation;
};

// Records tracks during a replay. Each body's pose is stored only when it changes, since most
// bodies rest most of the time.
class BodyWatch {
 public:
  // The level must outlive this object.
  explicit BodyWatch(const level::LevelView& level) : level_(level), stays_(level.bodyCount) {}

  // Expects every moment of the trajectory, in order.
  void see(const sim::Moment& now);

  // Returns one track for each part that moves by more than kBodyMiss.
  std::vector<BodyTrack> tracks() const;

 private:
  const level::LevelView& level_;
  std::vector<std::vector<BodyStay>> stays_;  // one list of poses per body
  size_t count_ = 0;                          // number of moments
};

}  // namespace obby::view
