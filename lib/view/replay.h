// Replays trajectory records in the simulator, since they hold actions only, and compares the end
// with the record.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "level/level.h"
#include "schema/obby.capnp.h"
#include "view/body_track.h"
#include "view/part_events.h"

namespace obby::view {

// Bits of Playback::state.
constexpr uint8_t kAirborne = 1;
constexpr uint8_t kDead = 2;

// A replayed trajectory, one sample per tick from the start; at least one sample.
struct Playback {
  std::vector<Vec3> feet;  // studs
  std::vector<uint16_t> yaw;
  std::vector<uint8_t> state;
  std::vector<PartEvent> events;
  std::vector<MotionEvent> motions;
  bool partsCut = false;  // events were omitted: PartEvents::cut
  std::vector<BodyTrack> bodies;
  std::vector<uint32_t> jumpTicks;  // ticks of jumps
  schema::Outcome outcome = schema::Outcome::RUNNING;
  int32_t part = -1;  // part that killed the player, or -1
  // Difference between the replay and the record; empty if they agree.
  std::string mismatch;

  uint32_t jumps() const { return uint32_t(jumpTicks.size()); }
  uint32_t ticks() const { return uint32_t(feet.size()) - 1; }
};

// `query` may be null: then there are no regions and limits, and outcomes that depend on them are
// not compared. Errors have `path` set.
Result<Playback> playBack(const level::Level& level, const level::Query* query,
                          schema::Trajectory::Reader record);

}  // namespace obby::view
