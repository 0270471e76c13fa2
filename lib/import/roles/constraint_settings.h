// Reads the properties of constraints and body movers, by their names in files. Falls back to the
// class defaults.
#pragma once

#include "engine/classes/class_defaults.h"
#include "import/document/tree.h"

namespace obby::importer {

class ConstraintSettings {
 public:
  // The tree must outlive this object.
  explicit ConstraintSettings(const Tree& tree) : tree_(tree) {}

  double number(InstanceId constraint, const char* name) const {
    return get<double>(tree_.at(constraint), name);
  }
  Vec3 vector(InstanceId constraint, const char* name) const {
    return get<Vec3>(tree_.at(constraint), name);
  }
  // Returns the number of an enum item.
  uint32_t choice(InstanceId constraint, const char* name) const {
    return get<EnumItem>(tree_.at(constraint), name).value;
  }
  bool isEnabled(InstanceId constraint) const { return flag(constraint, "Enabled", true); }
  // Returns true if a slider limits its travel.
  bool hasLimits(InstanceId constraint) const { return flag(constraint, "LimitsEnabled", false); }
  bool hasAngularLimits(InstanceId constraint) const {
    const bool turns = tree_.at(constraint).className == "HingeConstraint";
    return flag(constraint, turns ? "LimitsEnabled" : "AngularLimitsEnabled", false);
  }

 private:
  bool flag(InstanceId constraint, const char* name, bool absent) const {
    return propertyOr(tree_.at(constraint), name, absent);
  }

  const Tree& tree_;
};

}  // namespace obby::importer
