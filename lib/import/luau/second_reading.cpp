// Handlers of touches that harm nobody as their script has begun, read once more: by then a lever
// may be on, and a trap awake. Of that only the harm counts, and nothing that it sets or connects.
// What other scripts set is known once all have been read: where a handler has asked for some of
// that, its script is read anew (script_reading.cpp).
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "import/luau/reader.h"
#include "import/script_side.h"
#include "import/words.h"

namespace obby::importer::luau {
namespace {

constexpr size_t kStepsAgain = 100000;  // of a script: the first readings of others come first

// What a script that harms has in its text.
constexpr std::string_view kHarmWords[] = {"Health",      "TakeDamage",    "BreakJoints",
                                           "breakJoints", "LoadCharacter", "StateType.Dead"};

// Of what a handler does the harm alone, and in no more room than that takes. A line that gives
// health gives another amount, maybe.
Timeline harmOf(Timeline timeline, const std::set<int>& heals) {
  std::erase_if(timeline.events, [&](const ScriptEvent& event) {
    const bool untold = event.number && std::isnan(*event.number);
    return !event.harms() || (untold && heals.count(event.line) > 0);
  });
  timeline.events.shrink_to_fit();
  timeline.again = true;
  timeline.forever = false;
  timeline.loopEvent = 0;
  return timeline;
}

// One thing instead of another is not told apart.
bool isOther(const Datum& before, const Datum& now) {
  if (before.as<Ref>() && now.as<Ref>()) return false;
  return truthOf(compared("==", before, now)) != Truth::yes;
}

}  // namespace

bool Reader::mentionsHarm() const {
  const auto* source = property<std::string>(tree_.at(reading_.script), "Source");
  return source && hasAny(*source, kHarmWords);
}

// After the first reading of a handler.
void Reader::keepHarmless(const Pending& pending) {
  if (again_ || !mayHarm_ || lower(pending.signal) != "touched") return;
  const auto& events = timeline_.events;
  if (std::any_of(events.begin(), events.end(), std::mem_fn(&ScriptEvent::harms))) return;
  harmless_.push_back(pending);
  for (const ScriptEvent& event : events)
    if (event.kind == EventKind::damage && event.number.value_or(0) < 0) heals_.insert(event.line);
}

// Comes last: what it changes in the reader is not set back.
void Reader::readAgain() {
  if (harmless_.empty()) return;
  ScriptReading first = std::exchange(reading_, ScriptReading());
  reading_.script = first.script;
  const size_t later = budget_ - std::min(budget_, kStepsAgain);
  budget_ -= later;
  again_ = true;
  variables_.readAgain();
  for (const Pending& handler : harmless_) {
    const size_t before = room_.left();
    if (!spend() || !room_.take()) break;
    follow(handler);
    pending_.clear();
    Timeline harm = harmOf(std::move(reading_.timelines.back()), heals_);
    reading_.timelines.clear();
    const size_t kept = harm.events.empty() ? 0 : roomOf(harm);
    room_.giveBack(before - room_.left() - kept);
    if (kept > 0) first.timelines.push_back(std::move(harm));
  }
  first.cutAgain = budget_ == 0 || isFull();
  budget_ += later;
  reading_ = std::move(first);
}

// What is set in play, and not as play starts or before there are handlers, may be the one or the
// other by the time of a touch, and so may what is set in a branch that may not be taken.
void Reader::noteTurn(InstanceId id, const std::string& name, const std::optional<Datum>& old,
                      const Datum& now) {
  const bool late = time_ > 0 && (followed_ > 0 || !pending_.empty());
  const bool inPlay = inHandler_ || timeline_.forever || late;
  const bool maybe = unsure_ > 0 || skipped_;
  if (!mayHarm_ || !(inPlay || maybe) || isPoseProperty(name)) return;
  if (turned_.count({id, name}) > 0) return;  // long texts are not compared again and again
  const Datum before = old ? *old : fileField(id, name).value_or(Datum{});
  if (isOther(before, now)) turned_.insert({id, name});
}

// Whenever and under whatever condition it is set: what other scripts do then the text of this one
// does not tell.
void Reader::noteChange(InstanceId id, const std::string& name, const Datum& now) {
  if (again_ || isPoseProperty(name) || name.size() > kLongestKey) return;
  const Key key{id, name};
  if (changed_.count(key) > 0 || !isOther(fileField(id, name).value_or(Datum{}), now)) return;
  if (changed_.size() < kMaxKeys)
    changed_.insert(key);
  else
    reading_.cutChanges = true;
}

// Whether a handler that is read once more may find either; not where it has set it itself.
bool Reader::isTurned(InstanceId id, const std::string& name) {
  if (!again_) return false;
  const Key key{id, name};
  if (beforeHandler_.count(key) > 0) return false;
  if (turned_.count(key) > 0) return true;
  if (asked_.size() < kMaxKeys && name.size() <= kLongestKey) asked_.insert(key);
  return changes_ && changes_->reach(key, reading_.script, runsOnClient(tree_.at(reading_.script)));
}

}  // namespace obby::importer::luau
