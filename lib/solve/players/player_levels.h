// The levels that a level is for other players: compiled when first asked for, kept with it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "base/result.h"
#include "level/player.h"

namespace obby::solve {

struct LoadedLevel;

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

}  // namespace obby::solve
