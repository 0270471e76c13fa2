// The constants of the world and its player: gravity, speeds, health, the fall height.
#pragma once

#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

// Launch speed for each unit of JumpPower (measured).
constexpr double kJumpPowerGain = 1.06;

// How a player jumps: its power, or the height that it reaches, as UseJumpPower says.
struct Jump {
  bool usesPower = true;
  double power = 50;
  double height = 7.2;  // studs

  // Studs a second at take-off under `gravity` (studs/s²).
  float speed(float gravity) const;
};

// What StarterPlayer, or a StarterHumanoid in it, gives to each new character.
Jump jumpOf(const Tree& tree);

// Fills level.world and level.avatar from Workspace, StarterPlayer and a StarterHumanoid; a model
// file keeps the defaults. What would make the player another one (a custom character, the
// Character Controller Library) is noted in level.unmodelled.
void readWorld(const Tree& tree, LevelDraft& level);

}  // namespace obby::importer
