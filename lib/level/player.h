// A player: a body, and the frame rate at which the body's controller runs. Both change the
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
  std::string body;        // name of a row of bodies(); empty: the level's physics
  uint16_t frameRate = 0;  // of a row of frameRates(); 0: the level's controlRate

  bool isLevels() const { return body.empty() && frameRate == 0; }
  auto operator<=>(const Player&) const = default;
};

// A tick is a frame, and holds a whole number of physics steps.
struct FrameRate {
  uint16_t framesPerSecond, substeps;
};

// Steps are 1/240 s, except at 144 frames a second: there they are 1/288 s.
std::span<const FrameRate> frameRates();
// "30, 60, 120, 144 or 240", for errors.
std::string frameRateNames();

// The body of a query that is played with the level's physics.
inline constexpr const char* kPlaceBody = "place";

// Every combination of the query's bodies and frame rates, bodies outermost, without repeats. One
// player if the query names neither. Error: an unknown body or frame rate; its path is the field.
Result<std::vector<Player>> playersOf(schema::Query::Reader query);
bool namesPlayers(schema::Query::Reader query);
Result<Player> playerOf(schema::Trajectory::Reader trajectory);

// Makes the level this player's. Error: as above.
Status setPlayer(const Player& player, schema::Level::Builder level);
// Makes the query the level's own, for a level of `to` ticks per second instead of `from`: the
// start keeps its time, and the players are removed.
void setRate(uint16_t from, uint16_t to, schema::Query::Builder query);

// The tick nearest to the time of `tick`.
uint32_t tickAtRate(uint32_t tick, uint32_t from, uint32_t to);
// The first tick that is not earlier.
uint32_t nextTickAtRate(uint32_t tick, uint32_t from, uint32_t to);

}  // namespace obby::level
