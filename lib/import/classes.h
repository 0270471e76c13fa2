// Which Roblox classes are parts, joints, scripts, values: the one place that names them in groups.
#pragma once

#include <string_view>

namespace obby::importer {

// BasePart and everything that derives from it, but Terrain.
bool isPartClass(std::string_view className);
// Holds two parts rigidly together (Motor6D too: nothing animates level parts).
bool isRigidJointClass(std::string_view className);
// A constraint or mover that can move parts or limit them without being rigid.
bool isFreeConstraintClass(std::string_view className);
// Script, LocalScript, ModuleScript.
bool isScriptClass(std::string_view className);
// IntValue, StringValue and the others whose `Value` is a setting.
bool isValueClass(std::string_view className);
// What players carry or wear: never level geometry.
bool isGearClass(std::string_view className);

}  // namespace obby::importer
