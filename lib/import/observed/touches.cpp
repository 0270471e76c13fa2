// What a touch or a use does: each probe against what happened by itself in the same time.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "import/checkpoints.h"
#include "import/motion.h"
#include "import/observed/probe_effects.h"
#include "import/observed/roles.h"
#include "import/observed/settle.h"
#include "import/pose_math.h"

namespace obby::importer {
namespace {

constexpr float kForever = 3600;

class Touches {
 public:
  Touches(RoleContext& context, const engine::Report& report)
      : context_(context), report_(report) {}

  void take(const engine::Probe& probe) {
    PartDraft* const part = partOf(probe);
    const ProbeEffects effects = effectsOf(report_, probe);
    const bool used = probe.approach == engine::Approach::use;
    if (!part) {
      takeAbility(probe, effects);
      return;
    }
    if (probe.lost) {
      context_.level.noteUnmodelled("touch that broke down", path(part->id),
                                    "treated as a plain part");
      return;
    }
    if (!effects.empty() && !probe.allOver) {
      context_.level.noteUnmodelled(
          "place where scripts act", path(part->id),
          "only a piece of the part is concerned: treated as a plain part");
      return;
    }
    if (effects.empty() && probe.byPlace) return;
    if (effects.empty()) {
      if (hasEvidence(*part, kHarmless)) return;
      part->evidence.push_back(
          {kHarmless, "scripts listen to it, and do nothing to a player", false});
      return;
    }
    if (probe.byPlace) part->touch = true;  // the script looks; it does not wait for a touch
    if (!used) takePlayer(*part, probe, effects);
    takeParts(*part, probe, effects);
  }

 private:
  // The part that a player touches: for a click or prompt the part that it is in.
  PartDraft* partOf(const engine::Probe& probe) {
    for (InstanceId id = probe.target; id < context_.tree.size(); id = context_.tree.at(id).parent)
      if (PartDraft* const part = context_.part(id)) return part;
    return nullptr;
  }
  std::string path(InstanceId id) const { return context_.tree.path(id); }
  std::string reason(engine::Line line) const { return lineReason(context_.tree, line); }

  static void prove(PartDraft& part, const char* role, const std::string& why) {
    part.evidence.push_back({role, why, false});
  }

  void takePlayer(PartDraft& part, const engine::Probe& probe, const ProbeEffects& effects) {
    if (effects.harm && !part.checkpoint && !part.goal && !hasEvidence(part, kHarmless)) {
      const Harmful& harm = *effects.harm;
      part.kill = {float(harm.damage), float(harm.cooldown)};
      prove(part, "kill", reason(harm.line));
    }
    if (effects.push) takePush(part, *effects.push);
    if (effects.teleport && !effects.harm) {
      Teleport to;
      to.position = effects.teleport->feet;
      to.turns = effects.teleport->turns;
      to.yaw = effects.teleport->yaw;
      part.teleport = to;
      prove(part, "teleport", reason(effects.teleport->line));
    }
    if (effects.boost) takeBoost(part, *effects.boost);
    if (effects.trips && !effects.harm) {
      part.trip = Trip{};
      prove(part, "trip", reason(effects.tripLine));
    }
    if (effects.stage && !part.checkpoint && !effects.harm) {
      part.checkpoint = effects.stage->number ? int(*effects.stage->number)
                                              : stageNumber(context_.tree, part.id, part.id);
      prove(part, "checkpoint", reason(effects.stage->line));
    }
    if (effects.force)
      context_.level.noteUnmodelled("force on the player", path(part.id),
                                    "does not act; " + reason(*effects.force));
    if (effects.gravity)
      context_.level.noteUnmodelled("gravity that a touch changes", path(part.id),
                                    "gravity stays as it is; " + reason(*effects.gravity));
    (void)probe;
  }

  // What a tool, a key or a button on the screen gives the player, wherever it is.
  void takeAbility(const engine::Probe& probe, const ProbeEffects& effects) {
    const bool keys = probe.target >= context_.tree.size() ||
                      context_.tree.at(probe.target).className == "UserInputService";
    if (effects.empty() && keys)
      context_.level.noteUnmodelled("keys that a script listens to", "",
                                    "what they do is not known: the player walks and jumps only");
    World& world = context_.level.world;
    if (effects.boost && effects.boost->walk > 0 && effects.boost->jump > 0) {
      world.walkSpeed = std::max(world.walkSpeed, base_.walkSpeed * effects.boost->walk);
      world.jumpSpeed = std::max(world.jumpSpeed, base_.jumpSpeed * effects.boost->jump);
      context_.level.noteIgnored("ability of the player", "",
                                 "used all the time; " + reason(effects.boost->line));
    }
    for (const Away& back : effects.backs)
      if (PartDraft* const other = context_.part(back.part);
          other && !back.seconds && !other->vanish) {
        other->solid = true;  // players use what helps them
        prove(*other, "solid", "once a button on the screen is used; " + reason(back.line));
      }
    if (!effects.aways.empty() || !effects.moved.empty())
      context_.level.noteUnmodelled("button on the screen", "", "the player does not use it");
    if (effects.gravity || effects.push || effects.teleport || effects.force || effects.jumps)
      context_.level.noteUnmodelled("ability of the player", "", "the player does not use it");
  }

  void takePush(PartDraft& part, const Push& push) {
    JumpPad pad;
    pad.velocity = push.velocity;
    pad.keepSideways = push.keepsSideways;
    if (pad.keepSideways) pad.velocity.x = pad.velocity.z = 0;
    if (pad.velocity.y == 0 && pad.velocity.x == 0 && pad.velocity.z == 0) return;
    part.jumpPad = pad;
    prove(part, "jumpPad", reason(push.line));
  }

  void takeBoost(PartDraft& part, const Booster& boost) {
    Boost own;
    own.walkSpeed = boost.walk;
    own.jumpSpeed = boost.jump;
    own.seconds = float(boost.seconds);
    own.forever = boost.forever;
    if (!(own.walkSpeed > 0) || !(own.jumpSpeed > 0)) {
      context_.level.noteUnmodelled("part that stops the player", path(part.id),
                                    reason(boost.line));
      return;
    }
    part.boost = own;
    prove(part, "boost", reason(boost.line));
  }

  void takeParts(PartDraft& part, const engine::Probe& probe, const ProbeEffects& effects) {
    const bool used = probe.approach == engine::Approach::use;
    bool presses = false;
    double longest = 0;
    bool forever = false;
    const std::string signal = "touch " + path(part.id);
    for (const Away& away : effects.aways) {
      PartDraft* const other = context_.part(away.part);
      if (!other || other->vanish) continue;
      Vanish vanish;
      vanish.delay = float(away.delay);
      vanish.away = away.seconds ? float(*away.seconds) : kGone;
      if (other != &part || used) {
        vanish.signal = signal;
        presses = true;
        forever = forever || !away.seconds;
        longest = std::max(longest, away.delay + away.seconds.value_or(0));
      }
      other->vanish = vanish;
      other->solid = true;
      prove(*other, "vanish", reason(away.line));
    }
    for (const Away& back : effects.backs) {
      PartDraft* const other = context_.part(back.part);
      if (!other || other->vanish) continue;
      Vanish vanish;
      vanish.delay = float(back.delay);
      vanish.signal = signal;
      vanish.inverted = true;
      presses = true;
      forever = forever || !back.seconds;
      longest = std::max(longest, back.delay + back.seconds.value_or(0));
      other->vanish = vanish;
      other->solid = true;
      prove(*other, "vanish", reason(back.line));
    }
    for (const Moved& moved : effects.moved) {
      PartDraft* const other = context_.part(moved.part);
      if (!other || other->motion) {
        if (other && other->motion->trigger == MotionTrigger::always)
          context_.level.noteUnmodelled("motion that a touch or click starts", path(moved.part),
                                        "keeps the motion of its own; " + reason(moved.line));
        continue;
      }
      auto motion = motionOf(moved.poses, 30);
      if (!motion) {
        context_.level.noteUnmodelled("motion that a touch or click starts", path(moved.part),
                                      "stays where it is; " + reason(moved.line));
        continue;
      }
      const bool own = other == &part && !used;
      motion->trigger = own ? MotionTrigger::touch : MotionTrigger::signal;
      if (motion->repeat != Repeat::once) motion->offset = 0;  // it rests where its keys begin
      if (!own) {
        motion->signal = signal;
        presses = true;
        const bool returns = samePose(moved.poses.front(), moved.poses.back());
        forever = forever || !returns;
        longest = std::max(longest, double(moved.poses.size()) / 60);
      }
      other->motion = motion;
      prove(*other, "motion", reason(moved.line));
    }
    if (presses) {
      part.button = Button{signal, forever ? kForever : float(longest), forever};
      prove(part, "button", "a touch changes other parts");
    }
    for (const auto& [id, line] : effects.sizes)
      context_.level.noteUnmodelled("size that scripts change", path(id),
                                    "stays as it is at the start; " + reason(line));
    for (const auto& [id, line] : effects.belts)
      context_.level.noteUnmodelled("conveyor that a touch changes", path(id), reason(line));
  }

  RoleContext& context_;
  const engine::Report& report_;
  const World base_ = context_.level.world;
};

}  // namespace

void touchesFromObservation(RoleContext& context, const engine::Report& report) {
  Touches touches(context, report);
  for (const engine::Probe& probe : report.probes) touches.take(probe);
}

}  // namespace obby::importer
