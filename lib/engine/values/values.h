// Value types of the engine that scripts compute with most: Vector3 and CFrame, in single precision
// as in the engine. Their metatables are in the registry under kVector3 and kCFrame. Their `__type`
// is the name that `typeof` returns. Private to lib/engine.
#pragma once

#include <limits>

#include "engine/vm/lua.h"
#include "math/vec.h"

namespace obby::engine {

// Registers the libraries bit32 and utf8: each sets its functions in the table at the top of the
// stack.
void registerBits(lua_State* L);
void registerCharacters(lua_State* L);

// Returns a number truncated to an integer and clamped to the type; 0 for NaN.
template <class T>
T integerOf(double number) {
  constexpr T kMin = std::numeric_limits<T>::min(), kMax = std::numeric_limits<T>::max();
  if (number != number) return 0;
  if (number <= double(kMin)) return kMin;
  return number >= double(kMax) ? kMax : T(number);
}

struct ValueType {
  const char* name;
  int slot;  // slot of the metatable in the registry
};
constexpr ValueType kVector3 = {"Vector3", 1 << 20};
constexpr ValueType kCFrame = {"CFrame", (1 << 20) + 1};

// Opens the libraries. Each sets the global of its name and leaves nothing on the stack.
void openVector3(lua_State* L);
void openCFrame(lua_State* L);
void openCFrameMakers(lua_State* L);  // called by openCFrame

void push(lua_State* L, Vec3 value);
void push(lua_State* L, const Pose& value);
// Returns null if the value at `index` is of another type.
const Vec3* toVector3(lua_State* L, int index);
const Pose* toCFrame(lua_State* L, int index);
// Raises a script error if the value at `index` is of another type.
const Vec3& checkVector3(lua_State* L, int index);
const Pose& checkCFrame(lua_State* L, int index);

// Makes a new metatable with the functions of `meta` and with __index, which calls `index` with the
// table of `methods` as its upvalue.
void openType(lua_State* L, ValueType type, const luaL_Reg* meta, const luaL_Reg* methods,
              lua_CFunction index);
// Ends __index. Returns the method with the name at stack index 2, or raises a script error.
int methodNamed(lua_State* L, ValueType type);
// Pushes new userdata of `size` bytes.
void* newValue(lua_State* L, ValueType type, size_t size);
// Returns the userdata at `index`, which must be positive, or null if it is of another type.
const void* toValue(lua_State* L, int index, ValueType type, size_t size);

}  // namespace obby::engine
