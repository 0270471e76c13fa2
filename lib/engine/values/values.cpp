#include "engine/values/values.h"

namespace obby::engine {
namespace {

int newIndex(lua_State* L) {
  return luaL_error(L, "%s cannot be assigned to", luaL_checkstring(L, 2));
}

}  // namespace

void openType(lua_State* L, ValueType type, const luaL_Reg* meta, const luaL_Reg* methods,
              lua_CFunction index) {
  lua_newtable(L);
  luaL_register(L, nullptr, meta);
  lua_pushstring(L, type.name);
  lua_setfield(L, -2, "__type");
  lua_pushliteral(L, "The metatable is locked");
  lua_setfield(L, -2, "__metatable");
  lua_pushcfunction(L, newIndex);
  lua_setfield(L, -2, "__newindex");
  lua_newtable(L);
  luaL_register(L, nullptr, methods);
  lua_pushcclosure(L, index, 1);
  lua_setfield(L, -2, "__index");
  lua_rawseti(L, LUA_REGISTRYINDEX, type.slot);
}

int methodNamed(lua_State* L, ValueType type) {
  lua_pushvalue(L, 2);
  lua_rawget(L, lua_upvalueindex(1));
  if (lua_isnil(L, -1))
    return luaL_error(L, "%s is not a valid member of %s", lua_tostring(L, 2), type.name);
  return 1;
}

void* newValue(lua_State* L, ValueType type, size_t size) {
  void* const value = lua_newuserdata(L, size);
  lua_rawgeti(L, LUA_REGISTRYINDEX, type.slot);
  lua_setmetatable(L, -2);
  return value;
}

const void* toValue(lua_State* L, int index, ValueType type, size_t size) {
  if (!lua_isuserdata(L, index) || lua_objlen(L, index) != size || !lua_getmetatable(L, index))
    return nullptr;
  lua_rawgeti(L, LUA_REGISTRYINDEX, type.slot);
  const bool same = lua_rawequal(L, -1, -2) != 0;
  lua_pop(L, 2);
  return same ? lua_touserdata(L, index) : nullptr;
}

}  // namespace obby::engine
