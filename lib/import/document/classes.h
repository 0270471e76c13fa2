// Groups the Roblox classes: parts, joints, scripts, values. No other file lists them.
#pragma once

#include <string_view>

namespace obby::importer {

// Returns true for BasePart and everything that derives from it, except Terrain.
bool isPartClass(std::string_view className);
// Returns true if the class holds two parts rigidly together. Motor6D counts: nothing animates
// level parts.
bool isRigidJointClass(std::string_view className);
// Returns true for a constraint or mover that can move or limit parts without being rigid.
bool isFreeConstraintClass(std::string_view className);
// Returns true for Script, LocalScript and ModuleScript.
bool isScriptClass(std::string_view className);
// Returns true for IntValue, StringValue and the others whose `Value` is a setting.
bool isValueClass(std::string_view className);
// Returns true for things that players carry or wear. They are never level geometry.
bool isGearClass(std::string_view className);

}  // namespace obby::importer
