// Handlers of touches that harm nobody as their script has begun, read once more: by then a lever
// may be on, and a trap awake. Of that only the harm counts, and nothing that it sets or connects.
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "import/luau/reader.h"
#include "import/words.h"

namespace obby::importer::luau {
namespace {

constexpr size_t kStepsAgain = 100000;  // of a script: the first readings of others come first

// What a script that harms has in its text.
constexpr std::string_view kHarmWords[] = {"Health",      "TakeDamage",    "BreakJoints",
                                           "breakJoints", "LoadCharacter", "StateType.Dead"};

// Of what a handler does the harm alone. A line that gives health gives another amount, maybe.
Timeline harmOf(Timeline timeline, const std::set<int>& heals) {
  std::erase_if(timeline.events, [&](const ScriptEvent& event) {
    const bool untold = event.number && std::isnan(*event.number);
    return !event.harms() || (untold && heals.count(event.line) > 0);
  });
  timeline.again = true;
  timeline.forever = false;
  timeline.loopEvent = 0;
  return timeline;
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
    if (!spend()) break;
    follow(handler);
    pending_.clear();
    Timeline harm = harmOf(std::move(reading_.timelines.back()), heals_);
    reading_.timelines.clear();
    if (!harm.events.empty()) first.timelines.push_back(std::move(harm));
  }
  first.cutAgain = budget_ == 0;
  budget_ += later;
  reading_ = std::move(first);
}

// What is set in play, and not as play starts or before there are handlers, may be the one or the
// other by the time of a touch, and so may what is set in a branch that may not be taken. One thing
// instead of another is not told apart.
void Reader::noteTurn(InstanceId id, const std::string& name, const std::optional<Datum>& old,
                      const Datum& now) {
  const bool late = time_ > 0 && (followed_ > 0 || !pending_.empty());
  const bool inPlay = inHandler_ || timeline_.forever || late;
  const bool maybe = unsure_ > 0 || skipped_;
  if (!mayHarm_ || !(inPlay || maybe) || isPoseProperty(name)) return;
  if (turned_.count({id, name}) > 0) return;  // long texts are not compared again and again
  const Datum before = old ? *old : fileField(id, name).value_or(Datum{});
  if (before.as<Ref>() && now.as<Ref>()) return;
  if (truthOf(compared("==", before, now)) != Truth::yes) turned_.insert({id, name});
}

// Whether a handler that is read once more may find either; not where it has set it itself.
bool Reader::isTurned(InstanceId id, const std::string& name) const {
  return again_ && turned_.count({id, name}) > 0 && beforeHandler_.count({id, name}) == 0;
}

}  // namespace obby::importer::luau
