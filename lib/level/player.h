// A player is a body and the frame rate at which the body's controller runs. Both change the
// physics of a level, so a level is compiled for each player.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "schema/obby.capnp.h"

namespace obby::level {

struct Player {
  std::string body;        // name of a row of bodies(); empty for the level's physics
  uint16_t frameRate = 0;  // rate of a row of frameRates(); 0 for the level's controlRate

  bool isLevels() const { return body.empty() && frameRate == 0; }
  auto operator<=>(const Player&) const = default;
};

// A tick is a frame, and holds a whole number of physics steps.
struct FrameRate {
  uint16_t framesPerSecond, substeps;
};

// Steps are 1/240 s, except at 144 frames per second, where they are 1/288 s.
std::span<const FrameRate> frameRates();
// Returns the frame rates for error messages: "30, 60, 120, 144 or 240".
std::string frameRateNames();

// The name that stands for the level's own physics in a query's bodies.
inline constexpr const char* kPlaceBody = "place";

// Returns every combination of the query's bodies and frame rates, bodies outermost, without
// repeats. Returns one player if the query names neither. An unknown body or frame rate is an
// error, with the path of the field.
Result<std::vector<Player>> playersOf(schema::Query::Reader query);
// Returns true if the query names bodies or frame rates.
bool namesPlayers(schema::Query::Reader query);
// Returns the player of a trajectory. Errors are those of playersOf().
Result<Player> playerOf(schema::Trajectory::Reader trajectory);

// Changes the level's physics to this player's. Errors are those of playersOf().
Status setPlayer(const Player& player, schema::Level::Builder level);
// Adapts a query to a level of `to` ticks per second instead of `from`. The start keeps its time,
// and the players are removed.
void setRate(uint16_t from, uint16_t to, schema::Query::Builder query);

// Returns the tick at rate `to` that is nearest to the time of `tick` at rate `from`.
uint32_t tickAtRate(uint32_t tick, uint32_t from, uint32_t to);
// Returns the first tick at rate `to` that is not earlier than the time of `tick` at rate `from`.
uint32_t nextTickAtRate(uint32_t tick, uint32_t from, uint32_t to);

}  // namespace obby::level
