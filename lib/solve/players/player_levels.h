// A level as other players meet it: compiled on first use, and kept with the level.
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

  // Returns `base` as the player meets it, or `base` itself if its physics are the player's. The
  // result is valid while both live. Error: the player is unknown, or the level is invalid at its
  // frame rate.
  Result<const LoadedLevel*> of(const LoadedLevel& base, const level::Player& player);

  // Returns the approximate size of all compiled levels, in bytes.
  uint64_t bytes() const { return bytes_; }

 private:
  std::map<level::Player, std::unique_ptr<LoadedLevel>> levels_;  // null: the base
  uint64_t bytes_ = 0;
};

}  // namespace obby::solve
