// An event is read against its timeline, and against what its script does that makes no events.
#include "import/onset.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "import/pose_math.h"
#include "import/script_side.h"

namespace obby::importer {
namespace {

constexpr std::string_view kSwitches[] = {"CanCollide", "CanTouch", "Anchored"};

bool isSwitch(const ScriptEvent& event) {
  return std::find(std::begin(kSwitches), std::end(kSwitches), event.property) !=
         std::end(kSwitches);
}

// True if the text says what the property becomes.
bool isStated(const ScriptEvent& event) {
  if (event.kind == EventKind::destroy) return true;
  if (event.property == "CFrame") return event.frame.has_value();
  if (isSize(event)) return event.vector && isFinite(*event.vector);
  if (isSwitch(event) || event.property == "Parent") return event.flag.has_value();
  if (event.property == "Transparency") return event.number && std::isfinite(*event.number);
  // Of a constraint, whose forces may be without bounds.
  const bool number = event.number && !std::isnan(*event.number);
  const bool vector = event.vector && !std::isnan(event.vector->x) &&
                      !std::isnan(event.vector->y) && !std::isnan(event.vector->z);
  return number || event.flag || vector;
}

}  // namespace

bool isSize(const ScriptEvent& event) {
  return event.property == "Size" || event.property == "size";
}

bool comesBack(const ScriptEvent& event) {
  return event.kind == EventKind::set && event.property == "Parent" && event.flag.value_or(false);
}

bool changesParts(const Tree& tree, const ScriptEvent& event) {
  if (event.target == kNoInstance) return false;
  if (event.kind == EventKind::destroy) return true;
  if (event.kind != EventKind::set && event.kind != EventKind::tween) return false;
  if (event.property == "CFrame" || event.property == "Parent") return true;  // of a model, too
  const bool ofAPart = isSize(event) || isSwitch(event) || event.property == "Transparency";
  return ofAPart && tree.isPart(event.target);
}

bool isLooped(const Timeline& timeline, size_t event) {
  return timeline.trigger == Trigger::frame || (timeline.forever && event >= timeline.loopEvent);
}

Onsets::Onsets(const Tree& tree, const ScriptReading& reading)
    : tree_(tree),
      onClient_(runsOnClient(tree.at(reading.script))),
      givesParents_(reading.givesParents),
      makesJoints_(reading.makesJoints) {
  for (const Timeline& timeline : reading.timelines) {
    if (!timeline.byItself()) continue;
    for (size_t i = 0; i < timeline.events.size(); ++i) {
      const ScriptEvent& event = timeline.events[i];
      if (event.kind == EventKind::build) built_.insert(event.property);
      if (comesBack(event) && (event.time < kAtOnce || isLooped(timeline, i)))
        returned_.insert(event.target);
    }
  }
}

// A part may be destroyed to make room for its copy, and a model after its parts were taken out;
// what leaves may come back at once or by the clock; what loses its anchor may be held by joints
// that the script makes.
bool Onsets::isDoubtful(const ScriptEvent& event) const {
  if (event.kind == EventKind::destroy) {
    if (returned_.count(event.target) > 0) return true;
    return tree_.isPart(event.target) ? built_.count(tree_.at(event.target).className) > 0
                                      : givesParents_;
  }
  return makesJoints_ && event.property == "Anchored" && !event.flag.value_or(true);
}

Onset Onsets::of(const Timeline& timeline, size_t index) const {
  const ScriptEvent& event = timeline.events[index];
  if (event.unsure || !isStated(event) || isDoubtful(event)) return Onset::unsure;
  const bool atOnce = timeline.trigger == Trigger::start && event.kind != EventKind::tween &&
                      event.time < kAtOnce && !isLooped(timeline, index);
  if (!atOnce) return Onset::later;
  return onClient_ ? Onset::ofAClient : Onset::atStart;
}

}  // namespace obby::importer
