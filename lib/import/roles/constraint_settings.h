// What scripts make of constraints and body movers. What they set for certain, to one value, counts
// as if the file had it, also after a wait: as with other motions, that has no beginning. What they
// set to and fro, perhaps, or when something triggers it changes in play. What a LocalScript sets
// outside of endless loops and tweens is for one player, and does not count.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "import/roles/role.h"

namespace obby::importer {

class ConstraintSettings {
 public:
  // Of all scripts of the context, which must outlive it.
  explicit ConstraintSettings(const RoleContext& context);

  // A property of a constraint, by the names of files; else the class default.
  double number(InstanceId constraint, const char* name) const;
  Vec3 vector(InstanceId constraint, const char* name) const;
  uint32_t choice(InstanceId constraint, const char* name) const;  // of an enum
  bool isEnabled(InstanceId constraint) const;
  bool hasLimits(InstanceId constraint) const;  // of the way
  bool hasAngularLimits(InstanceId constraint) const;

  // Why one of the properties changes in play, by itself or on a trigger: the line of the script.
  // Nothing: none does.
  std::optional<std::string> changeByItself(InstanceId constraint,
                                            std::span<const std::string_view> names) const;
  std::optional<std::string> changeOnTrigger(InstanceId constraint,
                                             std::span<const std::string_view> names) const;
  // The line of a LocalScript that sets one of them but once: for one player.
  std::optional<std::string> changeOfAClient(InstanceId constraint,
                                             std::span<const std::string_view> names) const;

 private:
  struct Write {
    const ScriptReading* reading = nullptr;
    const ScriptEvent* event = nullptr;
  };
  struct Setting {
    const ScriptEvent* value = nullptr;  // null: as in the file
    Write byItself, onTrigger, ofAClient;
  };
  void take(const ScriptReading& reading, const Timeline& timeline, const ScriptEvent& event,
            bool atStart, bool later);
  std::optional<std::string> change(InstanceId constraint, std::span<const std::string_view> names,
                                    Write Setting::*when) const;
  const ScriptEvent* valueOf(InstanceId constraint, const char* name) const;
  bool flag(InstanceId constraint, const char* name, bool absent) const;

  const Tree& tree_;
  std::map<std::pair<InstanceId, std::string>, Setting> settings_;
};

}  // namespace obby::importer
