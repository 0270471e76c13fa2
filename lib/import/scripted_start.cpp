// Plays what scripts do at once through on the drafts.
#include "import/scripted_start.h"

#include <algorithm>
#include <map>
#include <set>

#include "engine/classes/class_defaults.h"
#include "import/motion.h"
#include "import/onset.h"
#include "import/part_changes.h"
#include "import/pivot.h"
#include "import/pose_math.h"
#include "import/scripted_movers.h"
#include "import/tween_motion.h"

namespace obby::importer {
namespace {

constexpr size_t kMostLooks = 4000000;  // looks at an instance, in all: bounds the work

class StartOfPlay {
 public:
  explicit StartOfPlay(RoleContext& context) : context_(context), movers_(context) {}

  // An event that has its value.
  void take(const ScriptReading& reading, const ScriptEvent& event) {
    if (comesBack(event)) return;  // what it undoes is in doubt, and so not done
    now_ = {&reading, event.line};
    if (event.kind == EventKind::destroy) {
      remove(event.target);
    } else if (event.property == "CFrame") {
      place(event.target, goalOf(pivotNow(event.target), event));
    } else if (PartDraft* part = context_.part(event.target)) {
      set(*part, event);
    }
  }

  void finish() {
    changes_.settle(context_);
    if (!gone_.empty()) leaveOut();
  }

 private:
  // The draft, to be changed.
  PartDraft& changed(PartDraft& part, Aspect aspect) {
    changes_.expect(part, aspect, now_);
    return part;
  }

  void set(PartDraft& part, const ScriptEvent& event) {
    if (event.property == "CanCollide")
      changed(part, Aspect::solid).solid = *event.flag;
    else if (event.property == "CanTouch")
      changed(part, Aspect::touch).touch = *event.flag;
    else if (event.property == "Anchored")
      anchor(part, *event.flag);
    else if (event.property == "Transparency")
      changed(part, Aspect::transparency).transparency = float(std::clamp(*event.number, 0.0, 1.0));
    else
      changed(part, Aspect::size).size = boundedSize(*event.vector);
  }

  void anchor(const PartDraft& part, bool anchored) {
    if (isSpent()) return;
    anchored_[part.id] = anchored;
    if (!anchored || !part.anchored) rehang(part.id);  // else it is held already
  }

  bool isAnchored(InstanceId id) const {
    const auto own = anchored_.find(id);
    return own == anchored_.end() ? get<bool>(context_.tree.at(id), "Anchored") : own->second;
  }

  // One anchored part holds all that joints hang on it. Gives what hangs together.
  std::vector<InstanceId> rehang(InstanceId id) {
    const auto members = context_.assemblies.members(id);
    spend(members.size());
    const bool held = std::any_of(members.begin(), members.end(),
                                  [&](InstanceId member) { return isAnchored(member); });
    for (InstanceId member : members)
      if (PartDraft* part = context_.part(member); part && part->anchored != held)
        changed(*part, Aspect::anchored).anchored = held;
    return members;
  }

  // Where a part or the pivot of a model is by now.
  Pose pivotNow(InstanceId id) {
    const Tree& tree = context_.tree;
    if (const PartDraft* part = context_.part(id)) return part->pose;
    if (const PartDraft* primary = context_.part(primaryPartOf(tree, id))) return primary->pose;
    for (InstanceId up = id; up != kNoInstance; up = tree.at(up).parent) {
      const auto known = pivots_.find(up);
      if (known == pivots_.end()) continue;
      if (up == id) return known->second;
      return known->second * inverse(filePivot(up)) * filePivot(id);
    }
    return filePivot(id);
  }

  const Pose& filePivot(InstanceId id) {
    const auto known = filePivots_.find(id);
    if (known != filePivots_.end()) return known->second;
    return filePivots_.emplace(id, pivotOf(context_.tree, id)).first->second;
  }

  std::vector<InstanceId> partsBelow(InstanceId target) {
    std::vector<InstanceId> parts;
    size_t seen = 0;
    context_.tree.eachBelow(target, [&](InstanceId id) {
      ++seen;
      if (context_.part(id)) parts.push_back(id);
      return true;
    });
    spend(seen);
    return parts;
  }

  // A part or those of a model, and what hangs on them with the anchors of now.
  std::vector<InstanceId> movedWith(InstanceId target) {
    auto all = context_.tree.isPart(target) ? std::vector{target} : partsBelow(target);
    const size_t own = all.size();
    std::set<InstanceId> hung;
    for (size_t i = 0; i < own; ++i) {
      if (hung.count(all[i])) continue;
      const auto members = context_.assemblies.members(all[i]);
      spend(members.size());
      if (members.size() > 1) hung.insert(members.begin(), members.end());
      for (InstanceId member : members)
        if (!isAnchored(member)) all.push_back(member);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  void place(InstanceId target, const Pose& frame) {
    if (isSpent()) return;
    bool reflected = false;
    const Pose to = {frame.position, repairedRotation(frame.rotation, &reflected)};
    const Pose by = to * inverse(pivotNow(target));
    for (InstanceId id : movedWith(target))
      if (PartDraft* part = context_.part(id)) move(*part, id == target ? to : by * part->pose);
    if (context_.tree.isPart(target)) return;
    spend(pivots_.size());
    for (auto& [id, pivot] : pivots_)
      if (context_.tree.isUnder(id, target)) pivot = by * pivot;
    pivots_[target] = to;
  }

  // What the same script moves afterwards begins where its motion has it.
  void move(PartDraft& part, const Pose& to) {
    if (!isFinite(to.position)) return;
    const std::set<InstanceId>& movers = movers_.of(part.id);
    if (movers.empty()) {
      changed(part, Aspect::pose).pose = to;
      return;
    }
    const bool other = !movers.count(now_.reading->script) && !samePose(part.pose, to);
    if (other && named_.insert(part.id).second)
      context_.level.noteUnmodelled(
          "part that two scripts move", context_.tree.path(part.id),
          "one script places it elsewhere, the other moves it from its position in the file; " +
              now_.reason(context_.tree));
  }

  void remove(InstanceId target) {
    if (isSpent()) return;
    const auto parts = partsBelow(target);
    for (InstanceId id : parts) {
      gone_.try_emplace(id, now_);
      anchored_[id] = false;
    }
    std::set<InstanceId> hung;
    for (InstanceId id : parts) {
      if (hung.count(id)) continue;
      for (InstanceId member : rehang(id)) hung.insert(member);
    }
  }

  bool isSpent() {
    const InstanceId script = now_.reading->script;
    if (steps_ == 0 && named_.insert(script).second)
      context_.level.noteUnmodelled(
          "very long script", context_.tree.path(script),
          "its changes to parts are followed only until the budget ran out");
    return steps_ == 0;
  }
  void spend(size_t steps) { steps_ -= std::min(steps, steps_); }

  void leaveOut() {
    LevelDraft& level = context_.level;
    std::vector<PartDraft> kept;
    for (PartDraft& part : level.parts) {
      const auto gone = gone_.find(part.id);
      if (gone == gone_.end()) {
        kept.push_back(std::move(part));
        continue;
      }
      ++level.partsCulled;
      level.noteIgnored("part that a script destroys at start", context_.tree.path(part.id),
                        "left out; " + gone->second.reason(context_.tree));
    }
    level.parts = std::move(kept);
  }

  RoleContext& context_;
  ScriptedMovers movers_;
  Cause now_;
  PartChanges changes_;
  std::map<InstanceId, bool> anchored_;  // by scripts, each part for itself
  std::map<InstanceId, Pose> pivots_;    // of models, as scripts have set them
  std::map<InstanceId, Pose> filePivots_;
  std::map<InstanceId, Cause> gone_;
  std::set<InstanceId> named_;
  size_t steps_ = kMostLooks;
};

}  // namespace

void applyScriptedStart(RoleContext& context) {
  StartOfPlay start(context);
  for (const ScriptReading& reading : context.scripts) {
    const Onsets onsets(context.tree, reading);
    for (const Timeline& timeline : reading.timelines) {
      if (timeline.trigger != Trigger::start) continue;
      for (size_t i = 0; i < timeline.events.size(); ++i)
        if (changesParts(context.tree, timeline.events[i]) &&
            onsets.of(timeline, i) == Onset::atStart)
          start.take(reading, timeline.events[i]);
    }
  }
  start.finish();
}

}  // namespace obby::importer
