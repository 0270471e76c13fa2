// Speeds and weight that scripts give each new player.
#include <algorithm>
#include <cmath>

#include "import/observed/boost_effect.h"
#include "import/observed/roles.h"
#include "import/world.h"

namespace obby::importer {

const engine::PlayerState& settledPlayer(const engine::Report& report) {
  const auto& changes = report.undisturbed.changes;
  const auto isLate = [&](const engine::Change& change) {
    return change.time > report.lookedAgainAt && change.target == engine::kPlayer &&
           changesSpeed(change);
  };
  const engine::PlayerState& end = report.undisturbed.player;
  const bool isSettled =
      report.lookedAgainAt > 0 && end.alive && std::none_of(changes.begin(), changes.end(), isLate);
  return isSettled ? end : report.arrived;
}

void applyPlayerState(RoleContext& context, const ObservedPlace& place) {
  const engine::PlayerState& player = place.report.arrived;
  if (!place.ran || !player.alive) return;
  World& world = context.level.world;
  const engine::PlayerState& settled = settledPlayer(place.report);
  world.walkSpeed = float(settled.walkSpeed);
  world.jumpSpeed = settled.usesJumpPower
                        ? float(kJumpPowerGain * settled.jumpPower)
                        : float(std::sqrt(2 * double(world.gravity) * settled.jumpHeight));
  // A force that each new body is given.
  if (player.lift < double(world.gravity))
    world.gravity -= float(player.lift);
  else if (player.lift > 0)
    context.level.noteUnmodelled("force on the player", context.tree, kNoInstance,
                                 "it floats up; the force does not act");
  world.maxHealth = float(settled.maxHealth);
}

}  // namespace obby::importer
