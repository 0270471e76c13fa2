// Reads the constants of the world and its player: gravity, speeds, health, the fall height.
#pragma once

#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

// Launch speed for each unit of JumpPower (measured).
constexpr double kJumpPowerGain = 1.06;

// The jump of a player, by power or by height, as UseJumpPower says.
struct Jump {
  bool usesPower = true;
  double power = 50;
  double height = 7.2;  // studs

  // Returns the take-off speed in studs/s under `gravity` (studs/s²).
  float speed(float gravity) const;
};

// Returns the max slope of the level, in radians, for a MaxSlopeAngle in degrees.
float maxSlopeOf(double degrees);

// Returns the jump that StarterPlayer, or a StarterHumanoid in it, gives to each new character.
Jump jumpOf(const Tree& tree);

// Fills level.world and level.avatar from Workspace, StarterPlayer and a StarterHumanoid. A model
// file keeps the defaults. Settings that replace the player (a custom character, the Character
// Controller Library) are noted in level.unmodelled.
void readWorld(const Tree& tree, LevelDraft& level);

}  // namespace obby::importer
