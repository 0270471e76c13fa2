// The tables behind classes.h.
#include "import/document/classes.h"

#include <algorithm>
#include <array>

#include "engine/classes/class_defaults.h"

namespace obby::importer {
namespace {

template <size_t N>
bool contains(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::array<std::string_view, 8> kRigidJoints = {
    "Weld", "Snap", "ManualWeld", "WeldConstraint", "Glue", "Motor6D", "Motor", "RigidConstraint"};
constexpr std::array<std::string_view, 28> kFreeConstraints = {"HingeConstraint",
                                                               "PrismaticConstraint",
                                                               "CylindricalConstraint",
                                                               "BallSocketConstraint",
                                                               "RodConstraint",
                                                               "RopeConstraint",
                                                               "SpringConstraint",
                                                               "TorsionSpringConstraint",
                                                               "UniversalConstraint",
                                                               "PlaneConstraint",
                                                               "AlignPosition",
                                                               "AlignOrientation",
                                                               "LinearVelocity",
                                                               "AngularVelocity",
                                                               "VectorForce",
                                                               "LineForce",
                                                               "Torque",
                                                               "BodyPosition",
                                                               "BodyVelocity",
                                                               "BodyGyro",
                                                               "BodyAngularVelocity",
                                                               "BodyForce",
                                                               "BodyThrust",
                                                               "RocketPropulsion",
                                                               "NoCollisionConstraint",
                                                               "Rotate",
                                                               "RotateP",
                                                               "RotateV"};
constexpr std::array<std::string_view, 3> kScripts = {"Script", "LocalScript", "ModuleScript"};
constexpr std::array<std::string_view, 9> kValues = {
    "BoolValue",    "IntValue",    "NumberValue", "StringValue",           "ObjectValue",
    "Vector3Value", "CFrameValue", "Color3Value", "DoubleConstrainedValue"};

}  // namespace

bool isPartClass(std::string_view name) { return isA(name, "BasePart") && name != "Terrain"; }
bool isRigidJointClass(std::string_view name) { return contains(kRigidJoints, name); }
bool isFreeConstraintClass(std::string_view name) { return contains(kFreeConstraints, name); }
bool isScriptClass(std::string_view name) { return contains(kScripts, name); }
bool isValueClass(std::string_view name) { return contains(kValues, name); }
bool isGearClass(std::string_view name) {
  return isA(name, "BackpackItem") || isA(name, "Accoutrement") || name == "Backpack";
}

}  // namespace obby::importer
