#include "import/observed/effect_roles.h"

#include <algorithm>
#include <cmath>

#include "engine/classes/class_defaults.h"
#include "import/document/observed_place.h"
#include "import/stages/numbers.h"
#include "level/params.h"

namespace obby::importer {
namespace {

constexpr float kDeadly = 1e6f;  // damage above any health

const engine::Change* fieldIn(const engine::Observation& seen) {
  for (const engine::Change& change : seen.changes)
    if (change.property == "note force field") return &change;
  return nullptr;
}

// Returns the script line or spawn that gives players a temporary force field, which protects them
// from TakeDamage and explosions, or "" if none does.
std::string shieldIn(RoleContext& context, const engine::Report& report) {
  const Tree& tree = context.tree;
  const engine::Change* field = fieldIn(report.undisturbed);
  for (const engine::Probe& probe : report.probes) field = field ? field : fieldIn(probe.seen);
  for (const engine::Revisit& revisit : report.revisits)
    field = field ? field : fieldIn(revisit.probe.seen);
  if (field) return lineReason(tree, field->line);
  for (InstanceId id = 0; id < tree.size(); ++id) {
    const Instance& spawn = tree.at(id);
    if (spawn.className == "SpawnLocation" && context.part(id) && get<bool>(spawn, "Enabled") &&
        get<int64_t>(spawn, "Duration") > 0)
      return spawn.name + " gives one for " + std::to_string(get<int64_t>(spawn, "Duration")) +
             " s";
  }
  return {};
}

}  // namespace

EffectRoles::EffectRoles(RoleContext& context, const engine::Report& report)
    : context_(context), base_(context.level.world), shield_(shieldIn(context, report)) {}

std::string EffectRoles::reason(engine::Line line) const { return lineReason(context_.tree, line); }

void EffectRoles::prove(PartDraft& part, const char* role, const std::string& why) const {
  part.evidence.push_back({role, why, guessed_});
}

void EffectRoles::note(const char* kind, InstanceId id, const char* note, engine::Line line) {
  context_.level.noteUnmodelled(kind, context_.tree, id, note + reason(line));
}

void EffectRoles::takePlayer(PartDraft& part, const ProbeEffects& effects) {
  if (effects.harm && !part.checkpoint && !part.goal && !hasEvidence(part, kHarmless)) {
    part.kill = {float(effects.harm->damage), float(effects.harm->cooldown)};
    std::erase_if(part.evidence, [](const Evidence& e) { return e.role == "kill"; });
    prove(part, "kill", reason(effects.harm->line));
    if (effects.harm->stoppable && !shield_.empty())
      context_.level.noteUnmodelled("harm that a force field stops", context_.tree, part.id,
                                    "the simulated player has no force field; " + shield_);
    if (effects.harm->lasts)
      note("harm that goes on after a touch", part.id, "simulated as dealt all at once; ",
           effects.harm->line);
  }
  if (effects.ends && !part.goal && !hasEvidence(part, kHarmless)) {
    part.kill = Kill{kDeadly, 0};
    prove(part, "kill", "the player cannot continue; " + reason(*effects.ends));
  }
  if (effects.stateOff)
    note("part that stops the player", part.id, "a touch disables a player state; not simulated; ",
         *effects.stateOff);
  if (effects.push) takePush(part, *effects.push);
  if (effects.teleport && !effects.harm) takeTeleport(part, *effects.teleport);
  if (effects.boost) takeBoost(part, *effects.boost);
  if (effects.trips && !effects.harm) {
    part.trip = Trip{};
    prove(part, "trip", reason(*effects.trips));
  }
  if (effects.stage && !effects.harm) takeStage(part, *effects.stage);
  if (effects.won && !effects.harm && !part.goal) {
    part.goal = 0;
    prove(part, "goal", reason(*effects.won));
  }
  if (effects.force) note("force on the player", part.id, "not simulated; ", *effects.force);
}

void EffectRoles::takePush(PartDraft& part, const Push& push) {
  JumpPad pad;
  pad.velocity = push.velocity;
  pad.keepSideways = push.keepsSideways;
  if (pad.keepSideways) pad.velocity.x = pad.velocity.z = 0;
  if (pad.velocity.y == 0 && pad.velocity.x == 0 && pad.velocity.z == 0) return;
  if (push.seconds > 0) {
    pad.velocity.y = push.launchSpeed(context_.level.world.gravity);
    note("push that lasts", part.id, "simulated as one push; ", push.line);
  }
  part.jumpPad = pad;
  prove(part, "jumpPad", reason(push.line));
}

void EffectRoles::takeTeleport(PartDraft& part, const Teleported& to) {
  Teleport teleport;
  teleport.position = to.feet;
  teleport.turns = to.turns;
  teleport.yaw = to.yaw;
  part.teleport = teleport;
  prove(part, "teleport", reason(to.line));
}

void EffectRoles::takeBoost(PartDraft& part, const Booster& boost) {
  Boost own;
  own.walkSpeed = boost.walk;
  own.jumpSpeed = boost.jump;
  own.gravity = boost.gravity;
  own.seconds = float(boost.seconds);
  own.forever = boost.forever;
  own.resets = boost.resets;
  if (!(own.walkSpeed > 0) || !(own.jumpSpeed > 0))
    return note("part that stops the player", part.id, "not simulated; ", boost.line);
  if (!(own.gravity >= 0) || own.gravity > kMaxBoostFactor ||
      own.gravity * base_.gravity > kMaxGravity)
    return note("force on the player", part.id, "not simulated; ", boost.line);
  part.boost = own;
  prove(part, "boost", reason(boost.line));
}

void EffectRoles::takeStage(PartDraft& part, const StageSet& stage) {
  StageSigns& signs = part.stageSigns;
  if (stage.number && signs[NumberFrom::seen] == kUnnumbered)
    signs[NumberFrom::seen] = *stage.number;
  if (stage.team) signs.team = stage.team;
  if (stage.respawn != kNoInstance) signs.respawn = stage.respawn;
  if (part.checkpoint) return;
  part.checkpoint = kUnnumbered;
  readNumbers(context_.tree, part.id, part);
  const bool isLine = stage.line.script != kNoInstance;
  prove(part, "checkpoint", isLine ? reason(stage.line) : "players who touched it respawn there");
}

void EffectRoles::noteUnknown(engine::Approach approach) {
  const bool keys = approach == engine::Approach::keys, chat = approach == engine::Approach::chat;
  const char* const kind = keys   ? "keys that a script listens to"
                           : chat ? "chat that scripts listen to"
                                  : "input without a visible effect";
  context_.level.noteUnmodelled(kind, context_.tree, kNoInstance,
                                "its effect is unknown; the simulated player only walks and jumps");
}

void EffectRoles::takeAbility(engine::Approach approach, const engine::AirJumps& inAir,
                              const ProbeEffects& effects) {
  LevelDraft& level = context_.level;
  const bool keys = approach == engine::Approach::keys;
  const bool leaps = keys && inAir.count > 0;
  if (leaps) {
    level.world.airJumps = std::min(inAir.count, kAnyAirJumps);
    level.noteIgnored("ability of the player", "",
                      "the player can jump in the air; " + reason(inAir.line));
  }
  if (effects.empty() && !leaps) noteUnknown(approach);
  constexpr double kMinSeconds = 1;  // shorter boosts do not help a jump
  const bool isTaken =
      effects.boost && !effects.boost->forever && effects.boost->seconds < kMinSeconds;
  if (isTaken)
    level.noteIgnored("ability of the player", "",
                      "it lasts less than 1 s; ignored; " + reason(effects.boost->line));
  const bool falls = effects.boost && effects.boost->gravity == 1 && !isTaken;
  if (falls && effects.boost->walk > 0 && effects.boost->jump > 0 && !effects.boost->resets) {
    World& world = level.world;
    world.walkSpeed = std::max(world.walkSpeed, base_.walkSpeed * effects.boost->walk);
    world.jumpSpeed = std::max(world.jumpSpeed, base_.jumpSpeed * effects.boost->jump);
    level.noteIgnored("ability of the player", "",
                      "simulated as always in use; " + reason(effects.boost->line));
  }
  for (const Away& back : effects.backs)
    if (PartDraft* const other = context_.part(back.part);
        other && !back.seconds && !other->vanish) {
      other->solid = true;  // players use the key or button if it helps
      prove(*other, "solid",
            "solid once the player uses keys, chat or a screen button; " + reason(back.line));
    }
  if (!effects.aways.empty() || !effects.moved.empty())
    level.noteUnmodelled("button on the screen", context_.tree, kNoInstance,
                         "the simulated player never uses it");
  if ((effects.boost && !falls && !isTaken) || effects.push || effects.teleport || effects.force ||
      (effects.jumps && !leaps))
    level.noteUnmodelled("ability of the player", context_.tree, kNoInstance,
                         "the simulated player never uses it");
}

}  // namespace obby::importer
