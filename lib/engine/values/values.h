// Value types of the engine that scripts compute with all the time: Vector3 and CFrame, in single
// precision as in the engine. Their metatables are in the registry under kVector3 and kCFrame, and
// have `__type`, the name that `typeof` gives.
// Private to lib/engine.
#pragma once

#include <limits>

#include "engine/vm/lua.h"
#include "math/vec.h"

namespace obby::engine {

// The libraries bit32 and utf8: each sets its functions in the table at the top of the stack.
void registerBits(lua_State* L);
void registerCharacters(lua_State* L);

// A number as an integer: the nearest that there is, 0 for what is no number.
template <class T>
T integerOf(double number) {
  constexpr T kLeast = std::numeric_limits<T>::min(), kMost = std::numeric_limits<T>::max();
  if (number != number) return 0;
  if (number <= double(kLeast)) return kLeast;
  return number >= double(kMost) ? kMost : T(number);
}

struct ValueType {
  const char* name;
  int slot;  // of the metatable in the registry
};
constexpr ValueType kVector3 = {"Vector3", 1 << 20};
constexpr ValueType kCFrame = {"CFrame", (1 << 20) + 1};

// The libraries: each leaves nothing on the stack and sets the global of its name.
void openVector3(lua_State* L);
void openCFrame(lua_State* L);
void openCFrameMakers(lua_State* L);  // called by openCFrame

void push(lua_State* L, Vec3 value);
void push(lua_State* L, const Pose& value);
// Null if the value at `index` is of another type.
const Vec3* toVector3(lua_State* L, int index);
const Pose* toCFrame(lua_State* L, int index);
// A script's error if it is.
const Vec3& checkVector3(lua_State* L, int index);
const Pose& checkCFrame(lua_State* L, int index);

// A new metatable with the functions of `meta`, and with __index, which calls `index` with the
// table of `methods` as its upvalue.
void openType(lua_State* L, ValueType type, const luaL_Reg* meta, const luaL_Reg* methods,
              lua_CFunction index);
// Ends __index: the method that has the name at stack index 2, or a script's error.
int methodNamed(lua_State* L, ValueType type);
// New userdata of `size` bytes; it stays on the stack.
void* newValue(lua_State* L, ValueType type, size_t size);
// The userdata at `index`, which is positive; null if it is of another type.
const void* toValue(lua_State* L, int index, ValueType type, size_t size);

}  // namespace obby::engine
