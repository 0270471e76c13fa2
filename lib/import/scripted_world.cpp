// Settings are collected from all scripts before the jump is worked out: which of them applies, and
// how fast it is, depends on the others.
#include "import/scripted_world.h"

#include <cmath>

#include "import/world.h"

namespace obby::importer {
namespace {

bool givesCharacter(const RoleContext& context, const ScriptReading& reading,
                    const Timeline& timeline) {
  if (timeline.signal == "CharacterAdded" || timeline.signal == "characterAdded") return true;
  return timeline.trigger == Trigger::start && isInStarterCharacter(context.tree, reading.script);
}

bool isWorldSetting(const RoleContext& context, const Timeline& timeline, const ScriptEvent& event,
                    bool character) {
  const std::string& name = event.property;
  if (event.kind == EventKind::character && character)
    return name == "WalkSpeed" || name == "UseJumpPower" || name == "JumpPower" ||
           name == "JumpHeight";
  return event.kind == EventKind::set && name == "Gravity" && timeline.trigger == Trigger::start &&
         event.target != kNoInstance && event.target == context.tree.service("Workspace");
}

// False if the text does not tell the value.
bool take(const ScriptEvent& event, World& world, Jump& jump) {
  if (event.property == "UseJumpPower") {
    if (event.flag) jump.usesPower = *event.flag;
    return event.flag.has_value();
  }
  if (!event.number || !std::isfinite(*event.number)) return false;
  if (event.property == "Gravity")
    world.gravity = float(*event.number);
  else if (event.property == "WalkSpeed")
    world.walkSpeed = float(*event.number);
  else if (event.property == "JumpPower")
    jump.power = *event.number;
  else
    jump.height = *event.number;
  return true;
}

}  // namespace

void applyScriptedWorld(RoleContext& context) {
  LevelDraft& level = context.level;
  Jump jump = jumpOf(context.tree);
  for (const ScriptReading& reading : context.scripts)
    for (const Timeline& timeline : reading.timelines) {
      const bool character = givesCharacter(context, reading, timeline);
      for (const ScriptEvent& event : timeline.events) {
        if (!isWorldSetting(context, timeline, event, character)) continue;
        const std::string reason = scriptReason(context.tree, reading, event.line);
        if (event.unsure)
          level.noteUnmodelled(
              event.property + " that a script may set", reason,
              "the condition for setting it is unknown; stays as the place has it");
        else if (take(event, level.world, jump))
          level.noteIgnored(event.property + " set by a script", reason,
                            "applied to the whole level");
        else
          level.noteUnmodelled(event.property + " that a script computes", reason,
                               "stays as the place has it");
      }
    }
  level.world.jumpSpeed = jump.speed(level.world.gravity);
}

}  // namespace obby::importer
