// A role is lost from the end of the handler on that it comes from, or while that is not connected,
// or does something else.
#include "import/ended_handlers.h"

#include <algorithm>
#include <set>
#include <string>

namespace obby::importer {
namespace {

bool comesBack(const PartDraft& part, const std::string& property) {
  const bool goes = property == "CanCollide" || property == "Anchored" || property == "Parent";
  return goes && part.vanish && !part.vanish->timer && part.vanish->away < kGone;
}

// Whether the part does what the event of its touch does, each time.
bool doesAgain(const PartDraft& part, const ScriptEvent& event) {
  switch (event.kind) {
    case EventKind::damage: return part.kill.has_value();
    case EventKind::push: return part.jumpPad.has_value();
    case EventKind::teleport: return part.teleport.has_value();
    case EventKind::set:
    case EventKind::destroy: return event.target == part.id && comesBack(part, event.property);
    default: return false;
  }
}

// Whether it is this that makes it a kill part, and nothing more certain.
bool isGuessedBy(const PartDraft& part, const std::string& reason) {
  return std::any_of(part.evidence.begin(), part.evidence.end(), [&](const Evidence& e) {
    return e.role == "kill" && e.guessed && e.reason == reason;
  });
}

// Whether a script begins anew with each character, and its flags with it.
bool beginsAnew(const Tree& tree, InstanceId script) {
  if (isInStarterCharacter(tree, script)) return true;
  InstanceId root = script;
  while (tree.at(root).parent != kNoInstance) root = tree.at(root).parent;
  return tree.at(root).className == "StarterGui" || tree.at(root).className == "StarterPack";
}

class EndedHandlers {
 public:
  explicit EndedHandlers(RoleContext& context) : context_(context) {}

  void note(const ScriptReading& reading, const Timeline& timeline) {
    const bool touch = timeline.trigger == Trigger::touch;
    const PartDraft* touched = touch ? context_.part(timeline.touched) : nullptr;
    for (const ScriptEvent& event : timeline.events) {
      const bool polls = !touch && reading.isWoken() && event.harms();
      const PartDraft* does = polls ? context_.part(event.target) : touched;
      if (does && doesAgain(*does, event)) noteTouch(reading, timeline, event, *does);
      if (timeline.cutLine == 0) continue;
      const bool moves = event.property == "CFrame" && event.target != kNoInstance;
      if (!timeline.byItself() || !moves || !seen_.insert(event.target).second) continue;
      for (const PartDraft* part : context_.partsOf(event.target))
        if (part->motion) nameCut(reading, timeline, *part);
    }
    seen_.clear();
  }

 private:
  void noteTouch(const ScriptReading& reading, const Timeline& timeline, const ScriptEvent& event,
                 const PartDraft& part) {
    if (event.harms() && reading.isLater(timeline))
      return nameDoubtful(part, scriptReason(context_.tree, reading, event.line));
    if (named_.count(part.id) > 0) return;
    if (timeline.cutLine > 0) return nameCut(reading, timeline, part);
    if (event.onceLine == 0) return;
    const bool kills = event.kind == EventKind::damage && !event.number;
    if (kills && beginsAnew(context_.tree, reading.script)) return;
    name(part, "handler that works only once",
         "in the level it works every time; " +
             scriptReason(context_.tree, reading, event.onceLine));
  }

  void nameDoubtful(const PartDraft& part, const std::string& reason) {
    if (!isGuessedBy(part, reason) || !doubtful_.insert(part.id).second) return;
    context_.level.noteUnmodelled(
        "damage that a script may deal", context_.tree.path(part.id),
        "in the level every touch deals it, whatever the script's condition; " + reason);
  }

  void nameCut(const ScriptReading& reading, const Timeline& timeline, const PartDraft& part) {
    name(part, "handler that a script disconnects",
         "in the level it stays connected and works every time; " +
             scriptReason(context_.tree, reading, timeline.cutLine));
  }

  void name(const PartDraft& part, const char* kind, const std::string& why) {
    if (named_.insert(part.id).second)
      context_.level.noteUnmodelled(kind, context_.tree.path(part.id), why);
  }

  RoleContext& context_;
  std::set<InstanceId> named_, doubtful_;
  std::set<InstanceId> seen_;  // what the events of one timeline move: loops have thousands
};

// Whether the script shows what the part does. One that others enable gives but guesses, and its
// harm has a name of its own.
bool isShownBy(const Tree& tree, const ScriptReading& reading, const PartDraft& part) {
  const std::string script = "script " + tree.at(reading.script).name + " line ";
  return std::any_of(part.evidence.begin(), part.evidence.end(), [&](const Evidence& e) {
    if (reading.isWoken() && (e.role == "kill" || !e.guessed)) return false;
    return e.role != "scripted" && e.reason.rfind(script, 0) == 0;
  });
}

// What a touch does by a handler that a condition which the text does not tell may keep from it.
void noteMaybe(RoleContext& context, const ScriptReading& reading, const Timeline& timeline) {
  const bool maybe = timeline.trigger == Trigger::touch && timeline.maybe && !timeline.again;
  const PartDraft* part = maybe ? context.part(timeline.touched) : nullptr;
  if (!part || !(part->kill || part->vanish || part->jumpPad || part->teleport)) return;
  if (isShownBy(context.tree, reading, *part))
    context.level.noteUnmodelled(
        "handler that a script may connect", context.tree.path(part->id),
        "the condition for connecting it is unknown; treated as connected; " +
            scriptReason(context.tree, reading, timeline.line));
}

// What a script that another one enables does by itself, as if it were enabled from the start on.
void noteWoken(RoleContext& context, const ScriptReading& reading) {
  std::set<InstanceId> seen, named;
  for (const Timeline& timeline : reading.timelines) {
    if (!timeline.byItself()) continue;
    for (const ScriptEvent& event : timeline.events) {
      if (event.target == kNoInstance || !seen.insert(event.target).second) continue;
      for (const PartDraft* part : context.partsOf(event.target))
        if (isShownBy(context.tree, reading, *part) && named.insert(part->id).second)
          context.level.noteUnmodelled("script that another script enables",
                                       context.tree.path(part->id),
                                       "treated as enabled from the start; " + reading.enabledBy);
    }
  }
}

}  // namespace

void noteEndedHandlers(RoleContext& context) {
  EndedHandlers handlers(context);
  for (const ScriptReading& reading : context.scripts) {
    for (const Timeline& timeline : reading.timelines) {
      if (timeline.cutLine > 0 || timeline.trigger == Trigger::touch || reading.isWoken())
        handlers.note(reading, timeline);
      noteMaybe(context, reading, timeline);
    }
    if (reading.isWoken()) noteWoken(context, reading);
  }
}

}  // namespace obby::importer
