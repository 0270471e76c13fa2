// What scripts make of each new player's speeds.
#include <cmath>

#include "import/observed/roles.h"

namespace obby::importer {

void applyPlayerState(LevelDraft& level, const ObservedPlace& place) {
  constexpr double kPerJumpPower = 1.06;
  const engine::PlayerState& player = place.report.arrived;
  if (!place.ran || !player.alive) return;
  World& world = level.world;
  world.walkSpeed = float(player.walkSpeed);
  world.jumpSpeed = player.usesJumpPower
                        ? float(kPerJumpPower * player.jumpPower)
                        : float(std::sqrt(2 * double(world.gravity) * player.jumpHeight));
  world.maxHealth = float(player.maxHealth);
}

}  // namespace obby::importer
