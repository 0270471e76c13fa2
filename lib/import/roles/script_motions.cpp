// Two motions of one part, and the order in which parts get theirs.
#include "import/roles/script_motions.h"

#include <algorithm>
#include <utility>

#include "import/motion.h"
#include "import/tween_mixer.h"
#include "import/tween_motion.h"

namespace obby::importer {
namespace {

constexpr const char* kTwo = "part that two scripts move";

// As TweenService lets tweens of Position and Orientation go on side by side.
bool combine(ScriptMotion& first, const ScriptMotion& second) {
  const bool goesFirst = first.places;
  const ScriptMotion& goes = goesFirst ? first : second;
  const ScriptMotion& turns = goesFirst ? second : first;
  if (!goes.places || goes.turns || turns.places) return false;
  if (goes.motion.spin || goes.motion.keys.empty()) return false;
  if (!turns.motion.spin || turns.motion.keys.size() > 1) return false;
  const Mat3 start =
      turns.motion.keys.empty() ? turns.rest : turns.motion.keys.front().pose.rotation;
  Motion both = goes.motion;
  addSpin(both, *turns.motion.spin, start, -double(turns.motion.offset));
  first.motion = std::move(both);
  first.reason += "; " + second.reason;
  first.guessed = first.guessed || second.guessed;
  first.places = first.turns = true;
  first.markers.insert(second.markers.begin(), second.markers.end());
  return true;
}

}  // namespace

void takeEvents(ScriptMotion& motion, const PoseEvents& events) {
  for (const ScriptEvent* event : events) {
    motion.places = motion.places || event->places;
    motion.turns = motion.turns || event->turns;
    motion.guessed = motion.guessed || event->unsure;
    if (event->from != kNoInstance) motion.markers.insert(event->from);
  }
}

bool isMovedByAScript(const PartDraft* part) {
  return part && part->motion &&
         std::any_of(part->evidence.begin(), part->evidence.end(), [](const Evidence& e) {
           return e.role == "motion" && e.reason.rfind("script ", 0) == 0;
         });
}

void ScriptMotions::add(ScriptMotion found) {
  const auto [known, isNew] = known_.try_emplace(found.id, given_ + waiting_.size());
  if (!isNew) {
    const bool waits = known->second >= given_;
    if (!waits || !combine(waiting_[known->second - given_], found))
      leave(found.id, kTwo, "only the first motion counts; " + found.reason);
    return;
  }
  keys_ += found.motion.keys.size();
  waiting_.push_back(std::move(found));
  if (keys_ > kMaxLevelKeys) give();  // bounds the memory
}

void ScriptMotions::leave(InstanceId id, const char* kind, const std::string& why) {
  if (context_.hasParts(id)) context_.level.noteUnmodelled(kind, context_.tree.path(id), why);
}

void ScriptMotions::leaveMixed(InstanceId id, bool tooLong, const std::string& reason) {
  if (!tooLong)
    return leave(
        id, "overlapping tweens",
        "they do not combine into one motion; stays at its position in the file; " + reason);
  leave(id, "motion of too many poses",
        "its overlapping or stopped tweens need more than " + std::to_string(kMostMixedKeys) +
            " poses (linear, fewer or shorter tweens need less); stays at its position in the "
            "file; " +
            reason);
}

void ScriptMotions::give() {
  for (const ScriptMotion& found : waiting_) {
    const bool moved = isMovedByAScript(context_.part(found.id));
    giveMotion(context_, found.id, found.motion, found.reason, found.guessed);
    if (moved) leave(found.id, kTwo, "it moves with its model; " + found.reason);
    for (InstanceId marker : found.markers) hideMarker(context_, marker, found.id);
  }
  given_ += waiting_.size();
  waiting_.clear();
  keys_ = 0;
}

}  // namespace obby::importer
