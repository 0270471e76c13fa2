// Speeds and weight that scripts give each new player.
#include <cmath>

#include "import/observed/roles.h"
#include "import/world.h"

namespace obby::importer {

void applyPlayerState(RoleContext& context, const ObservedPlace& place) {
  const engine::PlayerState& player = place.report.arrived;
  if (!place.ran || !player.alive) return;
  World& world = context.level.world;
  world.walkSpeed = float(player.walkSpeed);
  world.jumpSpeed = player.usesJumpPower
                        ? float(kJumpPowerGain * player.jumpPower)
                        : float(std::sqrt(2 * double(world.gravity) * player.jumpHeight));
  // A force that each new body is given.
  if (player.lift < double(world.gravity))
    world.gravity -= float(player.lift);
  else if (player.lift > 0)
    context.level.noteUnmodelled("force on the player", context.tree, kNoInstance,
                                 "it floats up; the force does not act");
  world.maxHealth = float(player.maxHealth);
}

}  // namespace obby::importer
