// Sorts what scripts set of constraints by when they do.
#include "import/roles/constraint_settings.h"

#include "engine/classes/class_defaults.h"
#include "import/classes.h"
#include "import/onset.h"

namespace obby::importer {
namespace {

bool sameValue(const ScriptEvent& a, const ScriptEvent& b) {
  return a.number == b.number && a.flag == b.flag && a.vector.has_value() == b.vector.has_value() &&
         (!a.vector || *a.vector == *b.vector);
}

}  // namespace

ConstraintSettings::ConstraintSettings(const RoleContext& context) : tree_(context.tree) {
  for (const ScriptReading& reading : context.scripts) {
    const Onsets onsets(tree_, reading);
    for (const Timeline& timeline : reading.timelines)
      for (size_t i = 0; i < timeline.events.size(); ++i) {
        const ScriptEvent& event = timeline.events[i];
        const bool sets = event.kind == EventKind::set || event.kind == EventKind::tween;
        if (!sets || event.target == kNoInstance ||
            !isFreeConstraintClass(tree_.at(event.target).className))
          continue;
        const bool endless =
            isLooped(timeline, i) || (event.kind == EventKind::tween && event.tween.repeats < 0);
        if (onsets.areOfAClient() && timeline.byItself() && !endless) {
          settings_[{event.target, event.property}].ofAClient = {&reading, &event};
          continue;
        }
        const Onset onset = onsets.of(timeline, i);
        const bool later = onset == Onset::later && event.kind == EventKind::set;
        take(reading, timeline, event, onset == Onset::atStart, later);
      }
  }
}

// `later`: it is set for certain, after a wait or again and again.
void ConstraintSettings::take(const ScriptReading& reading, const Timeline& timeline,
                              const ScriptEvent& event, bool atStart, bool later) {
  Setting& setting = settings_[{event.target, event.property}];
  if (!timeline.byItself()) {
    if (!setting.onTrigger.event) setting.onTrigger = {&reading, &event};
  } else if (atStart || (later && !setting.value)) {
    setting.value = &event;
  } else if (!setting.byItself.event && !(setting.value && sameValue(*setting.value, event))) {
    setting.byItself = {&reading, &event};
  }
}

const ScriptEvent* ConstraintSettings::valueOf(InstanceId constraint, const char* name) const {
  const auto known = settings_.find({constraint, name});
  return known == settings_.end() ? nullptr : known->second.value;
}

double ConstraintSettings::number(InstanceId constraint, const char* name) const {
  const ScriptEvent* value = valueOf(constraint, name);
  return value && value->number ? *value->number : get<double>(tree_.at(constraint), name);
}

Vec3 ConstraintSettings::vector(InstanceId constraint, const char* name) const {
  const ScriptEvent* value = valueOf(constraint, name);
  return value && value->vector ? *value->vector : get<Vec3>(tree_.at(constraint), name);
}

uint32_t ConstraintSettings::choice(InstanceId constraint, const char* name) const {
  const ScriptEvent* value = valueOf(constraint, name);
  if (value && value->number && *value->number >= 0 && *value->number < 100)
    return uint32_t(*value->number);
  return get<EnumItem>(tree_.at(constraint), name).value;
}

bool ConstraintSettings::flag(InstanceId constraint, const char* name, bool absent) const {
  const ScriptEvent* value = valueOf(constraint, name);
  return value && value->flag ? *value->flag : propertyOr(tree_.at(constraint), name, absent);
}

bool ConstraintSettings::isEnabled(InstanceId constraint) const {
  return flag(constraint, "Enabled", true);
}

bool ConstraintSettings::hasLimits(InstanceId constraint) const {
  return flag(constraint, "LimitsEnabled", false);
}

bool ConstraintSettings::hasAngularLimits(InstanceId constraint) const {
  const bool turns = tree_.at(constraint).className == "HingeConstraint";
  return flag(constraint, turns ? "LimitsEnabled" : "AngularLimitsEnabled", false);
}

std::optional<std::string> ConstraintSettings::change(InstanceId constraint,
                                                      std::span<const std::string_view> names,
                                                      Write Setting::*when) const {
  for (const std::string_view name : names) {
    const auto known = settings_.find({constraint, std::string(name)});
    if (known == settings_.end()) continue;
    const Write& write = known->second.*when;
    if (write.event) return scriptReason(tree_, *write.reading, write.event->line);
  }
  return std::nullopt;
}

std::optional<std::string> ConstraintSettings::changeByItself(
    InstanceId constraint, std::span<const std::string_view> names) const {
  return change(constraint, names, &Setting::byItself);
}

std::optional<std::string> ConstraintSettings::changeOnTrigger(
    InstanceId constraint, std::span<const std::string_view> names) const {
  return change(constraint, names, &Setting::onTrigger);
}

std::optional<std::string> ConstraintSettings::changeOfAClient(
    InstanceId constraint, std::span<const std::string_view> names) const {
  return change(constraint, names, &Setting::ofAClient);
}

}  // namespace obby::importer
