#include "engine/luau/helpers.h"

#include <cmath>
#include <lua.hpp>
#include <string>

#include "engine/luau/number_text.h"

namespace obby::luau {
namespace {

// Returns the __type in the value's metatable, or else its Lua type.
const char* typeName(lua_State* state, int index) {
  if (luaL_getmetafield(state, index, "__type") && lua_type(state, -1) == LUA_TSTRING)
    return lua_tostring(state, -1);  // the metatable keeps it alive
  return luaL_typename(state, index);
}

// Calls a metamethod of the value at `of` with the values at a and b. Returns false if there is
// none.
bool callMeta(lua_State* state, const char* event, int of, int a, int b) {
  if (!luaL_getmetafield(state, of, event)) return false;
  lua_pushvalue(state, a);
  lua_pushvalue(state, b);
  lua_call(state, 2, 1);
  return true;
}

int length(lua_State* state) {
  luaL_checkany(state, 1);
  if (lua_type(state, 1) != LUA_TSTRING && callMeta(state, "__len", 1, 1, 1)) return 1;
  if (lua_type(state, 1) != LUA_TSTRING && !lua_istable(state, 1))
    return luaL_error(state, "attempt to get length of a %s value", typeName(state, 1));
  lua_pushnumber(state, lua_Number(lua_objlen(state, 1)));
  return 1;
}

int quotient(lua_State* state) {
  lua_settop(state, 2);
  if (lua_isnumber(state, 1) && lua_isnumber(state, 2)) {
    lua_pushnumber(state, std::floor(lua_tonumber(state, 1) / lua_tonumber(state, 2)));
    return 1;
  }
  if (callMeta(state, "__idiv", 1, 1, 2) || callMeta(state, "__idiv", 2, 1, 2)) return 1;
  const char* const left = typeName(state, 1);
  const char* const right = typeName(state, 2);
  if (std::string_view(left) == right)
    return luaL_error(state, "attempt to perform arithmetic (idiv) on %s", left);
  return luaL_error(state, "attempt to perform arithmetic (idiv) on %s and %s", left, right);
}

bool isText(lua_State* state, int index) {
  return lua_type(state, index) == LUA_TSTRING || lua_type(state, index) == LUA_TNUMBER;
}

// Replaces a number by its text.
void toText(lua_State* state, int index) {
  if (lua_type(state, index) != LUA_TNUMBER) return;
  const std::string text = numberText(lua_tonumber(state, index));
  lua_pushlstring(state, text.data(), text.size());
  lua_replace(state, index);
}

// Joins the two values on top into one.
int joinTwo(lua_State* state) {
  const int right = lua_gettop(state), left = right - 1;
  if (isText(state, left) && isText(state, right)) {
    toText(state, left);
    toText(state, right);
    lua_concat(state, 2);
    return 1;
  }
  if (!callMeta(state, "__concat", left, left, right) &&
      !callMeta(state, "__concat", right, left, right))
    return luaL_error(state, "attempt to concatenate %s with %s", typeName(state, left),
                      typeName(state, right));
  lua_replace(state, left);
  lua_settop(state, left);
  return 1;
}

// Joins the values 1 to `count`, which are the whole stack. Texts at the end are joined at once.
int join(lua_State* state, int count) {
  int top = count;
  while (top > 1) {
    int first = top;
    while (first > 0 && isText(state, first)) toText(state, first--);
    if (first + 1 < top) {
      lua_concat(state, top - first);
      top = first + 1;
    } else {
      joinTwo(state);
      --top;
    }
  }
  return 1;
}

int concatenate(lua_State* state) { return join(state, lua_gettop(state)); }

int concatenateList(lua_State* state) {
  const int count = int(lua_tointeger(state, 1));
  lua_settop(state, 2);
  luaL_checkstack(state, count, "too many operands of '..'");
  for (int i = 1; i <= count; ++i) lua_rawgeti(state, 2, i);
  lua_remove(state, 1);
  lua_remove(state, 1);
  return join(state, count);
}

// Replaces a value by its text, with the field tostring of the helpers.
void describe(lua_State* state, int index) {
  toText(state, index);
  if (lua_type(state, index) == LUA_TSTRING) return;
  lua_getfield(state, lua_upvalueindex(1), "tostring");
  lua_pushvalue(state, index);
  lua_call(state, 1, 1);
  if (lua_type(state, -1) != LUA_TSTRING) luaL_error(state, "'tostring' must return a string");
  lua_replace(state, index);
}

int interpolate(lua_State* state) {
  const int count = lua_gettop(state);
  for (int i = 1; i <= count; ++i) describe(state, i);
  lua_concat(state, count);
  return 1;
}

int iterate(lua_State* state) {
  lua_settop(state, 3);
  if (lua_isfunction(state, 1)) return 3;
  if (luaL_getmetafield(state, 1, "__iter")) {
    lua_pushvalue(state, 1);
    lua_call(state, 1, 3);
    return 3;
  }
  if (luaL_getmetafield(state, 1, "__call")) {
    lua_pop(state, 1);
    return 3;
  }
  if (!lua_istable(state, 1))
    return luaL_error(state, "attempt to iterate over a %s value", typeName(state, 1));
  lua_getfield(state, lua_upvalueindex(1), "next");
  lua_pushvalue(state, 1);
  lua_pushnil(state);
  return 3;
}

int all(lua_State* state) { return lua_gettop(state); }

int none(lua_State*) { return 0; }

int text(lua_State* state) {
  luaL_checkany(state, 1);
  lua_settop(state, 1);
  if (callMeta(state, "__tostring", 1, 1, 1)) {
    if (lua_type(state, -1) != LUA_TSTRING)
      return luaL_error(state, "'__tostring' must return a string");
    return 1;
  }
  switch (lua_type(state, 1)) {
    case LUA_TNIL: lua_pushliteral(state, "nil"); break;
    case LUA_TBOOLEAN: lua_pushstring(state, lua_toboolean(state, 1) ? "true" : "false"); break;
    case LUA_TNUMBER: toText(state, 1); break;
    case LUA_TSTRING: break;
    default: lua_pushfstring(state, "%s: %p", typeName(state, 1), lua_topointer(state, 1));
  }
  return 1;
}

int nextPair(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  lua_settop(state, 2);
  return lua_next(state, 1) ? 2 : (lua_pushnil(state), 1);
}

}  // namespace

void pushHelpers(lua_State* state) {
  constexpr luaL_Reg kFunctions[] = {
      {"len", length},    {"idiv", quotient},        {"cat", concatenate}, {"interp", interpolate},
      {"iter", iterate},  {"catn", concatenateList}, {"all", all},         {"none", none},
      {"tostring", text}, {"next", nextPair}};
  lua_newtable(state);
  for (const luaL_Reg& function : kFunctions) {
    lua_pushvalue(state, -1);
    lua_pushcclosure(state, function.func, 1);
    lua_setfield(state, -2, function.name);
  }
  lua_pushnumber(state, 0);
  lua_setfield(state, -2, "zero");
}

}  // namespace obby::luau
