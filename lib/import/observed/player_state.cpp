// Reads the speeds and weight that scripts give to each new player.
#include <algorithm>

#include "import/draft/world.h"
#include "import/observed/boost_effect.h"
#include "import/observed/roles.h"

namespace obby::importer {
namespace {

// Notes changes that scripts make to each new body and that the level has no field for.
void noteBody(RoleContext& context, const engine::Report& report) {
  World& world = context.level.world;
  for (const engine::Change& change : report.undisturbed.changes) {
    if (change.time > report.probedAt) return;
    const auto note = [&](const char* kind) {
      context.level.noteUnmodelled(kind, context.tree, kNoInstance,
                                   "not simulated; " + lineReason(context.tree, change.line));
    };
    const double* const number = std::get_if<double>(&change.value);
    if (change.property.rfind("note state off ", 0) == 0)
      note("state of the player that scripts switch off");
    else if (change.target == engine::kPlayer && change.property == "HipHeight")
      note("hip height that scripts change");
    else if (change.target == engine::kPlayer && change.property == "MaxSlopeAngle" && number)
      world.maxSlope = maxSlopeOf(*number);
  }
  if (report.arrived.stuck) {
    context.level.noteUnmodelled(
        "player that cannot walk", context.tree, kNoInstance,
        "scripts hold the player until an event that did not occur; simulated as free to walk");
  }
}

}  // namespace

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
  world.jumpSpeed =
      Jump{settled.usesJumpPower, settled.jumpPower, settled.jumpHeight}.speed(world.gravity);
  // Each new body gets this force.
  if (player.lift < double(world.gravity))
    world.gravity -= float(player.lift);
  else if (player.lift > 0)
    context.level.noteUnmodelled("force on the player", context.tree, kNoInstance,
                                 "it would make the player float up; not simulated");
  world.maxHealth = float(settled.maxHealth);
  noteBody(context, place.report);
}

}  // namespace obby::importer
