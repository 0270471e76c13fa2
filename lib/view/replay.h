// Trajectory records hold actions only: this plays them through the simulator and compares the end
// with what the record says.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "level/level.h"
#include "schema/obby.capnp.h"
#include "view/loose_track.h"
#include "view/part_events.h"

namespace obby::view {

// Bits of Playback::state.
constexpr uint8_t kAirborne = 1;
constexpr uint8_t kDead = 2;

// A playthrough tick by tick, the start first; at least one sample.
struct Playback {
  std::vector<Vec3> feet;  // studs
  std::vector<uint16_t> yaw;
  std::vector<uint8_t> state;
  std::vector<PartEvent> events;
  std::vector<MotionEvent> motions;
  bool partsCut = false;  // there are more of these than are kept: PartEvents::cut
  std::vector<LooseTrack> loose;
  std::vector<uint32_t> jumpTicks;  // at which a jump was made
  schema::Outcome outcome = schema::Outcome::RUNNING;
  int32_t part = -1;  // that killed the player
  // How the replay differs from the record; empty: it agrees in all that the record states.
  std::string mismatch;

  uint32_t jumps() const { return uint32_t(jumpTicks.size()); }
  uint32_t ticks() const { return uint32_t(feet.size()) - 1; }
};

// `query` may be null: no regions and limits then, and an outcome that only they can give is not
// compared. Errors have `path` set.
Result<Playback> playBack(const level::Level& level, const level::Query* query,
                          schema::Trajectory::Reader record);

}  // namespace obby::view
