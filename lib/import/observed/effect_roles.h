// Gives parts the roles that follow from what a touch or use was seen to do.
#pragma once

#include <string>

#include "import/observed/probe_effects.h"
#include "import/observed/shields.h"
#include "import/roles/role.h"

namespace obby::importer {

class EffectRoles {
 public:
  EffectRoles(RoleContext& context, const engine::Report& report)
      : context_(context), base_(context.level.world), shield_(shieldIn(context, report)) {}

  // Evidence that follows is a guess.
  void setGuessed(bool guessed) { guessed_ = guessed; }
  // What a touch of the part does to the player.
  void takePlayer(PartDraft& part, const ProbeEffects& effects);
  // What it does to parts, itself among them. `used`: by a click or prompt instead of a touch.
  void takeParts(PartDraft& part, bool used, const ProbeEffects& effects);
  // Returns true if the probe sets a joint or moves a part through one.
  bool setsJoints(const engine::Probe& probe) const;
  // What moves by constraints and movers that the touch sets. What it sets to no effect that the
  // level has is named.
  void takeDrives(PartDraft& part, const engine::Probe& probe, const ProbeEffects& effects);
  // What a tool, keys, chat or a button on the screen give the player, wherever it is.
  // `inAir`: the jumps in the air that keys give.
  void takeAbility(engine::Approach approach, const engine::AirJumps& inAir,
                   const ProbeEffects& effects);

  std::string path(InstanceId id) const { return context_.tree.path(id); }
  std::string reason(engine::Line line) const;

 private:
  // A use of what is in no part has shown no effect.
  void noteUnknown(engine::Approach approach);
  void prove(PartDraft& part, const char* role, const std::string& why) const;
  void takePush(PartDraft& part, const Push& push);
  void takeTeleport(PartDraft& part, const Teleported& to);
  void takeBoost(PartDraft& part, const Booster& boost);
  void takeStage(PartDraft& part, const StageSet& stage);
  // `inverted`: the part comes instead of going.
  void takeAway(PartDraft& part, bool used, const Away& away, bool inverted);
  // The part moves, or another one does.
  void takeMotion(PartDraft& part, PartDraft& other, const Moved& moved, bool used);
  // A touch of the part is felt elsewhere for that long; `held`: after its end.
  void press(PartDraft& part, double seconds, bool held = false);
  std::string signalOf(const PartDraft& part) const { return "touch " + path(part.id); }
  bool isJoint(InstanceId id) const;
  void note(const char* kind, InstanceId id, const char* note, engine::Line line);

  RoleContext& context_;
  const World base_;
  const std::string shield_;  // what gives players a force field; empty: nothing does
  bool guessed_ = false;
};

}  // namespace obby::importer
