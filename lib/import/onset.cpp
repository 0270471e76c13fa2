// An event is read against its timeline, and against what its script does that makes no events.
#include "import/onset.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "import/pose_math.h"

namespace obby::importer {
namespace {

constexpr uint32_t kRunClient = 2;  // RunContext
constexpr double kAtOnce = 1e-3;    // seconds: less than a frame

constexpr std::string_view kSwitches[] = {"CanCollide", "CanTouch", "Anchored"};
// What a script that joins parts has in its text.
constexpr std::string_view kJointWords[] = {"Weld", "MakeJoints", "Motor6D", "Constraint"};

bool isSwitch(const ScriptEvent& event) {
  return std::find(std::begin(kSwitches), std::end(kSwitches), event.property) !=
         std::end(kSwitches);
}

// True if the text says what the property becomes.
bool isStated(const ScriptEvent& event) {
  if (event.kind == EventKind::destroy) return true;
  if (event.property == "CFrame") return event.frame.has_value();
  if (isSize(event)) return event.vector && isFinite(*event.vector);
  if (isSwitch(event)) return event.flag.has_value();
  return event.number && std::isfinite(*event.number);
}

bool runsOnClient(const Instance& script) {
  const auto* context = property<EnumItem>(script, "RunContext");
  return script.className == "LocalScript" || (context && context->value == kRunClient);
}

// True if the text gives something another parent; `Parent = nil` gives none.
bool hasParents(std::string_view text) {
  constexpr std::string_view kBlanks = " \t";
  for (const std::string_view parent : {".Parent", ".parent"})
    for (size_t at = 0; (at = text.find(parent, at)) != std::string_view::npos;) {
      at = std::min(text.find_first_not_of(kBlanks, at + parent.size()), text.size());
      if (text.substr(at, 1) != "=" || text.substr(at, 2) == "==") continue;
      const size_t value = text.find_first_not_of(kBlanks, at + 1);
      if (value != std::string_view::npos && text.substr(value, 3) != "nil") return true;
    }
  return false;
}

bool hasJoints(std::string_view text) {
  return std::any_of(std::begin(kJointWords), std::end(kJointWords), [&](std::string_view word) {
    return text.find(word) != std::string_view::npos;
  });
}

}  // namespace

bool isSize(const ScriptEvent& event) {
  return event.property == "Size" || event.property == "size";
}

bool changesParts(const Tree& tree, const ScriptEvent& event) {
  if (event.target == kNoInstance) return false;
  if (event.kind == EventKind::destroy) return true;
  if (event.kind != EventKind::set && event.kind != EventKind::tween) return false;
  if (event.property == "CFrame") return true;  // a model's pivot, too
  const bool ofAPart = isSize(event) || isSwitch(event) || event.property == "Transparency";
  return ofAPart && tree.isPart(event.target);
}

bool isLooped(const Timeline& timeline, size_t event) {
  return timeline.trigger == Trigger::frame || (timeline.forever && event >= timeline.loopEvent);
}

Onsets::Onsets(const Tree& tree, const ScriptReading& reading)
    : tree_(tree), onClient_(runsOnClient(tree.at(reading.script))) {
  if (const auto* source = property<std::string>(tree.at(reading.script), "Source")) {
    givesParents_ = hasParents(*source);
    makesJoints_ = hasJoints(*source);
  }
  for (const Timeline& timeline : reading.timelines)
    if (timeline.byItself())
      for (const ScriptEvent& event : timeline.events)
        if (event.kind == EventKind::build) built_.insert(event.property);
}

// A part may be destroyed to make room for its copy, and a model after its parts were taken out;
// what loses its anchor may be held by joints that the script makes.
bool Onsets::isDoubtful(const ScriptEvent& event) const {
  if (event.kind == EventKind::destroy)
    return tree_.isPart(event.target) ? built_.count(tree_.at(event.target).className) > 0
                                      : givesParents_;
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
