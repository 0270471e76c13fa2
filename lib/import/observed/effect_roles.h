// Gives parts the roles that follow from observed effects of a touch or use.
#pragma once

#include <string>

#include "import/draft/role_context.h"
#include "import/observed/probe_effects.h"

namespace obby::importer {

class EffectRoles {
 public:
  EffectRoles(RoleContext& context, const engine::Report& report);

  // Marks the evidence that follows as a guess.
  void setGuessed(bool guessed) { guessed_ = guessed; }
  // Gives the part the effects that a touch has on the player.
  void takePlayer(PartDraft& part, const ProbeEffects& effects);
  // Gives parts the effects of a touch of `part`, or of a click or prompt if `used`. The part
  // itself may be among them.
  void takeParts(PartDraft& part, bool used, const ProbeEffects& effects);
  // Returns true if the probe sets a joint or moves a part through a joint.
  bool setsJoints(const engine::Probe& probe) const;
  // Gives parts the motion of constraints and movers that the touch sets. Notes those without an
  // effect that the level can express.
  void takeDrives(PartDraft& part, const engine::Probe& probe, const ProbeEffects& effects);
  // Adds the abilities that the player gets anywhere from a tool, keys, chat or a screen button.
  // `inAir`: mid-air jumps on a key press.
  void takeAbility(engine::Approach approach, const engine::AirJumps& inAir,
                   const ProbeEffects& effects);

  std::string path(InstanceId id) const { return context_.tree.path(id); }
  std::string reason(engine::Line line) const;

 private:
  // Notes the use of something outside all parts that has shown no effect.
  void noteUnknown(engine::Approach approach);
  void prove(PartDraft& part, const char* role, const std::string& why) const;
  void takePush(PartDraft& part, const Push& push);
  void takeTeleport(PartDraft& part, const Teleported& to);
  void takeBoost(PartDraft& part, const Booster& boost);
  void takeStage(PartDraft& part, const StageSet& stage);
  // `inverted`: the part appears instead of vanishing.
  void takeAway(PartDraft& part, bool used, const Away& away, bool inverted);
  // Gives `other`, which may be `part`, the motion that a touch or use of `part` starts.
  void takeMotion(PartDraft& part, PartDraft& other, const Moved& moved, bool used);
  // Makes the part a button for other parts. Its signal lasts for `seconds`; `held`: counted from
  // the end of the touch.
  void press(PartDraft& part, double seconds, bool held = false);
  std::string signalOf(const PartDraft& part) const { return "touch " + path(part.id); }
  bool isJoint(InstanceId id) const;
  void note(const char* kind, InstanceId id, const char* note, engine::Line line);

  RoleContext& context_;
  const World base_;
  const std::string shield_;  // source of players' force field; empty: none
  bool guessed_ = false;
};

}  // namespace obby::importer
