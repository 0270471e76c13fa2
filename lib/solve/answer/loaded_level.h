// A level of the stream, compiled for its own player, and for others on first use.
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

// Compiles a level for other players, on first use, and keeps the results.
class PlayerLevels {
 public:
  PlayerLevels();
  ~PlayerLevels();
  PlayerLevels(const PlayerLevels&) = delete;
  PlayerLevels& operator=(const PlayerLevels&) = delete;

  // Returns the level with the player's physics, or `base` if they are the same. The result is
  // valid while this object and `base` live. Error: the player is unknown, or the level is invalid
  // at its frame rate.
  Result<const LoadedLevel*> of(const LoadedLevel& base, const level::Player& player);

  // Returns the approximate size of all compiled levels, in bytes.
  uint64_t bytes() const { return bytes_; }

 private:
  std::map<level::Player, std::unique_ptr<LoadedLevel>> levels_;  // null: as the base
  uint64_t bytes_ = 0;
};

// A level of the stream, ready for queries.
struct LoadedLevel {
  io::Record record;
  level::Level level;
  double compileSeconds;
  // Levels of other players, shared by all queries of the level.
  std::unique_ptr<PlayerLevels> players = std::make_unique<PlayerLevels>();
};

Result<LoadedLevel> loadLevel(const io::Record& record);
// Returns the approximate memory of a level, in bytes: its record, its compiled form, and the
// levels for other players.
uint64_t bytesOf(const LoadedLevel& level);

}  // namespace obby::solve
