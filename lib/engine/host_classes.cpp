// Host functions for classes, enums and defaults.
#include <algorithm>

#include "engine/classes/class_defaults.h"
#include "engine/host.h"
#include "engine/values/values.h"

namespace obby::engine {
namespace class_functions {
namespace {

void pushText(lua_State* L, std::string_view text) { lua_pushlstring(L, text.data(), text.size()); }

std::string_view textAt(lua_State* L, int index) {
  size_t size = 0;
  const char* const text = luaL_checklstring(L, index, &size);
  return {text, size};
}

template <size_t kCount>
bool isIn(std::string_view text, const std::string_view (&list)[kCount]) {
  return std::find(list, list + kCount, text) != list + kCount;
}

// Pushes true if the string at index 1 is in the list.
template <size_t kCount>
int isOneOf(lua_State* L, const std::string_view (&list)[kCount]) {
  lua_pushboolean(L, isIn(textAt(L, 1), list));
  return 1;
}

int baseClass(lua_State* L) {
  const std::string_view* const base = Host::of(L).classes.baseOf(textAt(L, 1));
  if (!base) return 0;
  pushText(L, *base);
  return 1;
}

int member(lua_State* L) {
  const std::string_view code = Host::of(L).classes.member(textAt(L, 1), textAt(L, 2));
  if (code.empty()) return 0;
  pushText(L, code);
  return 1;
}

int enumItems(lua_State* L) {
  const std::string_view items = Host::of(L).classes.enumItems(textAt(L, 1));
  if (items.empty()) return 0;
  pushText(L, items);
  return 1;
}

// (class, property): returns the default that level files rely on; an enum item as its number.
int defaultValue(lua_State* L) {
  const Value* const value = defaultOf(textAt(L, 1), textAt(L, 2));
  if (!value) return 0;
  pushValue(L, *value);
  return 1;
}

int isAbstract(lua_State* L) {
  static constexpr std::string_view kAbstract[] = {
      "Instance",   "BasePart", "PVInstance", "ValueBase",     "Constraint", "LuaSourceContainer",
      "BaseScript", "GuiBase",  "GuiObject",  "JointInstance", "Player",     "Workspace",
      "DataModel"};
  return isOneOf(L, kAbstract);
}

// (class): returns true for a service. Its name ends in "Service" or is in this list.
int isService(lua_State* L) {
  static constexpr std::string_view kPlain[] = {
      "Workspace",     "Players",    "Lighting",        "ReplicatedStorage", "ReplicatedFirst",
      "ServerStorage", "StarterGui", "StarterPack",     "StarterPlayer",     "Teams",
      "Chat",          "Debris",     "MaterialService", "ContentProvider",   "CoreGui",
      "Stats",         "Selection",  "NetworkClient",   "NetworkServer",     "Geometry",
      "ScriptContext"};
  const std::string_view name = textAt(L, 1);
  if (name.size() <= 7 || !name.ends_with("Service")) return isOneOf(L, kPlain);
  lua_pushboolean(L, 1);
  return 1;
}

// Returns true if every property of the class's instances may move parts.
bool drivesParts(const ClassTable& classes, std::string_view name) {
  static constexpr std::string_view kBases[] = {"Constraint", "BodyMover"};
  const std::string_view* base = &name;
  while (base && !base->empty() && !isIn(*base, kBases)) base = classes.baseOf(*base);
  return base && !base->empty();
}

// (class, property): returns true if the observer records the property's changes.
int isWatched(lua_State* L) {
  static constexpr std::string_view kWatched[] = {"CFrame",
                                                  "Size",
                                                  "CanCollide",
                                                  "CanTouch",
                                                  "Anchored",
                                                  "Transparency",
                                                  "Velocity",
                                                  "RotVelocity",
                                                  "CollisionGroup",
                                                  "Shape",
                                                  "CustomPhysicalProperties",
                                                  "Material",
                                                  "Gravity",
                                                  "WalkSpeed",
                                                  "JumpPower",
                                                  "JumpHeight",
                                                  "UseJumpPower",
                                                  "MaxHealth",
                                                  "Enabled",
                                                  "Disabled",
                                                  "Massless",
                                                  "LineVelocity",
                                                  "VectorVelocity",
                                                  "AngularVelocity",
                                                  "MotorMaxTorque",
                                                  "TargetPosition",
                                                  "TargetAngle",
                                                  "Position",
                                                  "LineDirection",
                                                  "FallenPartsDestroyHeight",
                                                  "PlatformStand",
                                                  "HipHeight",
                                                  "MaxSlopeAngle",
                                                  "CharacterWalkSpeed",
                                                  "CharacterJumpPower",
                                                  "CharacterJumpHeight"};
  lua_pushboolean(L,
                  isIn(textAt(L, 2), kWatched) || drivesParts(Host::of(L).classes, textAt(L, 1)));
  return 1;
}

constexpr luaL_Reg kFunctions[] = {{"baseClass", baseClass},   {"member", member},
                                   {"enumItems", enumItems},   {"default", defaultValue},
                                   {"isAbstract", isAbstract}, {"isService", isService},
                                   {"isWatched", isWatched},   {nullptr, nullptr}};

}  // namespace
}  // namespace class_functions

void registerClassFunctions(lua_State* L) {
  luaL_register(L, nullptr, class_functions::kFunctions);
}

}  // namespace obby::engine
