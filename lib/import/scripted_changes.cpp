// An event is lost if the level's part does not do what it says; a kind of loss counts once a part.
#include "import/scripted_changes.h"

#include <set>
#include <utility>

#include "import/motion.h"
#include "import/onset.h"

namespace obby::importer {
namespace {

constexpr float kSameSize = 1e-3f;  // studs

struct Loss {
  const char* kind;
  const char* note;
};

Loss lossOf(const ScriptEvent& event, Onset onset) {
  if (isSize(event)) return {"size that a script changes", "stays as it is at the start of play"};
  if (onset == Onset::unsure)
    return {"part that a script may change",
            "it is not known whether or how it changes; stays as it is at the start of play"};
  if (onset == Onset::ofAClient)
    return {"part that a LocalScript changes",
            "the change is only for one player; stays as it is on the server"};
  return {"part that a script changes in play", "stays as it is at the start of play"};
}

class ScriptedChanges {
 public:
  explicit ScriptedChanges(RoleContext& context) : context_(context) {}

  void note(const ScriptReading& reading) {
    const Onsets onsets(context_.tree, reading);
    for (const Timeline& timeline : reading.timelines) {
      if (!timeline.byItself()) continue;
      for (size_t i = 0; i < timeline.events.size(); ++i) {
        const ScriptEvent& event = timeline.events[i];
        if (!changesParts(context_.tree, event) || !isLost(timeline, i)) continue;
        const Onset onset = onsets.of(timeline, i);
        if (onset != Onset::atStart) name(reading, event, lossOf(event, onset));
      }
    }
  }

 private:
  bool isLost(const Timeline& timeline, size_t index) {
    const ScriptEvent& event = timeline.events[index];
    const PartDraft* part = context_.part(event.target);
    if (event.kind == EventKind::destroy)
      return !(timeline.forever && part && part->vanish && part->vanish->timer);
    if (event.property == "Parent") return true;
    if (event.property == "CFrame") {
      // Loops and tweens make motions or are named with them, as is what is not known.
      if (isLooped(timeline, index) || event.kind == EventKind::tween || !event.frame) return false;
      return !part || (!part->motion && !samePose(part->pose, *event.frame));
    }
    if (!part) return false;
    if (isSize(event))
      return !event.vector || !(length(abs(*event.vector) - part->size) <= kSameSize);
    if (event.property == "CanCollide") return !part->vanish && event.flag != part->solid;
    if (event.property == "CanTouch") return event.flag != part->touch;
    return event.property == "Anchored" && !part->motion && event.flag != part->anchored;
  }

  void name(const ScriptReading& reading, const ScriptEvent& event, const Loss& loss) {
    if (!named_.insert({loss.kind, event.target}).second) return;
    const std::string reason = scriptReason(context_.tree, reading, event.line);
    for (InstanceId id : context_.tree.partsOf(event.target)) {
      const PartDraft* part = context_.part(id);
      // What comes back is missed only where the level is without it.
      if (comesBack(event) == (part != nullptr)) continue;
      const bool moves = part && event.property == "CFrame" && part->motion;
      if (!moves)
        context_.level.noteUnmodelled(loss.kind, context_.tree.path(id),
                                      std::string(loss.note) + "; " + reason);
    }
  }

  RoleContext& context_;
  std::set<std::pair<std::string, InstanceId>> named_;
};

}  // namespace

void noteScriptedChanges(RoleContext& context) {
  ScriptedChanges changes(context);
  for (const ScriptReading& reading : context.scripts) changes.note(reading);
}

}  // namespace obby::importer
