// A level of the stream, compiled: for its own player, and for others when they are first asked
// for.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "base/result.h"
#include "io/record.h"
#include "level/level.h"
#include "level/player.h"

namespace obby::solve {

struct LoadedLevel;

// The levels that a level is for other players: compiled when first asked for, kept with it.
class PlayerLevels {
 public:
  PlayerLevels();
  ~PlayerLevels();
  PlayerLevels(const PlayerLevels&) = delete;
  PlayerLevels& operator=(const PlayerLevels&) = delete;

  // `base` as the player meets it, `base` itself if its physics are the player's. Valid while both
  // live. Error: no such player; a level that is none at the player's frame rate.
  Result<const LoadedLevel*> of(const LoadedLevel& base, const level::Player& player);

  // Approximate size of all compiled levels.
  uint64_t bytes() const { return bytes_; }

 private:
  std::map<level::Player, std::unique_ptr<LoadedLevel>> levels_;  // null: the base
  uint64_t bytes_ = 0;
};

// A level of the stream, ready for queries.
struct LoadedLevel {
  io::Record record;
  level::Level level;
  double compileSeconds;
  // For all queries that are asked of it.
  std::unique_ptr<PlayerLevels> players = std::make_unique<PlayerLevels>();
};

Result<LoadedLevel> loadLevel(const io::Record& record);
// What keeping a level takes, in bytes, about: its record, compiled, and for other players.
uint64_t bytesOf(const LoadedLevel& level);

}  // namespace obby::solve
