// Where loose parts are during a playthrough: what the player pushes, and what falls by itself.
#pragma once

#include <cstdint>
#include <vector>

#include "level/level_view.h"
#include "sim/simulator.h"
#include "view/poses.h"

namespace obby::view {

// Poses of one part at some ticks. Between two of them, and all of the way, the part is where a
// straight line and an even turn from one to the next would have it, to kLooseMiss.
struct LooseTrack : Poses {
  uint32_t part = 0;
  std::vector<uint32_t> ticks;  // of the samples, since the start of the playthrough; ascending

  size_t bytes() const { return Poses::bytes() + ticks.size() * 4; }
};
constexpr float kLooseMiss = 2.5e-4f;  // studs, of any point of the part

// Where a body is from a tick on, until it moves again.
struct LooseStay {
  uint32_t tick;  // since the start of the playthrough
  Vec3 center;    // of mass
  Quat rotation;
};

// Gathers tracks while a playthrough is replayed: of each body where it is whenever that changes,
// for most of them rest most of the time.
class LooseWatch {
 public:
  // The level must outlive it.
  explicit LooseWatch(const level::LevelView& level) : level_(level), stays_(level.looseCount) {}

  // Every moment of the playthrough, in order.
  void see(const sim::Moment& now);

  // One for each part that moves by more than kLooseMiss.
  std::vector<LooseTrack> tracks() const;

 private:
  const level::LevelView& level_;
  std::vector<std::vector<LooseStay>> stays_;  // of each body
  size_t count_ = 0;                           // moments
};

}  // namespace obby::view
