// Host functions for threads, script chunks, and the differences between Luau's core and Lua's.
#include <algorithm>
#include <string>

#include "base/hash.h"
#include "engine/classes/class_defaults.h"
#include "engine/host.h"
#include "engine/luau/emit.h"
#include "engine/luau/helpers.h"
#include "engine/luau/parser.h"

namespace obby::engine {
namespace script_functions {
namespace {

int rawType(lua_State* L) {
  luaL_checkany(L, 1);
  lua_pushstring(L, lua_typename(L, lua_type(L, 1)));
  return 1;
}

int metatableOf(lua_State* L) { return lua_getmetatable(L, 1); }

// (function, arguments...): like Lua's pcall, but the function must not yield.
int tryCall(lua_State* L) {
  const bool good = lua_pcall(L, lua_gettop(L) - 1, LUA_MULTRET, 0) == 0;
  lua_pushboolean(L, good);
  lua_insert(L, 1);
  return lua_gettop(L);
}

// (kind, amount): spends from a budget. Raises an error once it is used up.
int spend(lua_State* L) {
  Host& host = Host::of(L);
  const std::string kind = luaL_checkstring(L, 1);
  const double amount = luaL_checknumber(L, 2);
  if (kind == "instances" && ++host.instancesMade > host.settings.instances) {
    host.greedy = host.owners[host.running];
    return luaL_error(L, "too many instances");
  }
  if (!(amount < 1e7)) return luaL_error(L, "not enough memory");
  return 0;
}

// Works as coroutine.resume, which is its upvalue. Lua counts the calls of each thread separately,
// so nested threads could use up the C stack.
int resume(lua_State* L) {
  constexpr size_t kMaxStack = size_t(3) << 20;  // bytes; one thread takes up to 2 MB
  if (Vm::of(L).stackUsed() < kMaxStack) return lua_tocfunction(L, lua_upvalueindex(1))(L);
  lua_pushboolean(L, 0);
  lua_pushliteral(L, "C stack overflow");
  return 2;
}

// (thread, arguments...): resumes a thread for the engine. Returns true if it succeeded, its
// yielded value or error, and true if its time was up. Then a new stretch begins, so that the
// engine can go on.
int runThread(lua_State* L) {
  const int results = resume(L);
  const bool good = lua_toboolean(L, -results) != 0;
  Vm& vm = Vm::of(L);
  const bool isLate = !good && vm.timedOut();
  if (isLate) vm.beginStretch();
  if (results > 1) lua_settop(L, lua_gettop(L) - results + 2);
  if (results == 1) lua_pushnil(L);
  lua_pushboolean(L, isLate);
  return 3;
}

int newId(lua_State* L) {
  lua_pushnumber(L, lua_Number(Host::of(L).nextMade++));
  return 1;
}

// (owner, first): sets the running owner and returns the previous one. If `first`, a new stretch
// begins.
int enter(lua_State* L) {
  Host& host = Host::of(L);
  lua_pushnumber(L, lua_Number(host.running));
  host.running = uint32_t(luaL_checknumber(L, 1));
  if (host.settings.runningScript) *host.settings.runningScript = host.owners[host.running];
  ++host.beat;
  if (lua_toboolean(L, 2) != 0) host.vm.beginStretch();
  return 1;
}

int isNative(lua_State* L) {
  lua_pushboolean(L, lua_iscfunction(L, 1));
  return 1;
}

int timedOut(lua_State* L) {
  lua_pushboolean(L, Host::of(L).vm.timedOut());
  return 1;
}

int newOwner(lua_State* L) {
  Host& host = Host::of(L);
  host.owners.push_back(InstanceId(luaL_checknumber(L, 1)));
  lua_pushnumber(L, lua_Number(host.owners.size() - 1));
  return 1;
}

// (script, source): returns the chunk; or nil, the problem, and true if the text is not Luau.
int load(lua_State* L) {
  size_t size = 0;
  const char* const text = luaL_checklstring(L, 2, &size);
  const std::string id = std::to_string(uint32_t(luaL_checknumber(L, 1)));
  const luau::Chunk chunk = luau::parse({text, size});
  const Result<std::string> lua = luau::emit(chunk);
  lua_pushnil(L);
  if (!lua) {
    lua_pushstring(L, ("#" + id + ":" + lua.error().place + ": " + lua.error().message).c_str());
    lua_pushboolean(L, chunk.broken);
    return 3;
  }
  if (luaL_loadbuffer(L, lua->data(), lua->size(), ("=#" + id).c_str()) == 0) return 1;
  return 2;
}

int where(lua_State* L) {
  lua_pushnumber(L, lua_Number(Host::of(L).where(L).line));
  return 1;
}

// (function): returns a hash of its line and of its script's text.
int functionHash(lua_State* L) {
  const Host& host = Host::of(L);
  lua_Debug at;
  lua_settop(L, 1);
  lua_getinfo(L, ">S", &at);
  const InstanceId script = Host::scriptOf(at.source);
  const bool known = script < host.document.instances.size();
  const std::string text =
      known ? get<std::string>(host.document.instances[script], "Source") : at.source;
  constexpr int kBits = 53;  // bits of an integer that a double represents exactly
  const uint64_t hash = hashBytes(text.data(), text.size(), uint64_t(at.linedefined));
  lua_pushnumber(L, lua_Number(hash >> (64 - kBits)));
  return 1;
}

// (text): records the text of an error that the real engine raises, too, and returns it.
int refused(lua_State* L) {
  Host::of(L).refused = luaL_checkstring(L, 1);
  return 1;
}

int rawLength(lua_State* L) {
  lua_pushnumber(L, lua_Number(lua_objlen(L, 1)));
  return 1;
}

// Returns a new list with the elements of a list of any length.
int copyList(lua_State* L) {
  const int size = int(lua_objlen(L, 1));
  lua_createtable(L, size, 0);
  for (int i = 1; i <= size; ++i) {
    lua_rawgeti(L, 1, i);
    lua_rawseti(L, -2, i);
  }
  return 1;
}

// Sets the methods of strings: ("x"):rep(2).
int setStringMethods(lua_State* L) {
  lua_pushliteral(L, "");
  lua_getmetatable(L, -1);
  lua_pushvalue(L, 1);
  lua_setfield(L, -2, "__index");
  lua_pushliteral(L, "The metatable is locked");
  lua_setfield(L, -2, "__metatable");
  return 0;
}

// (script): returns true if the settings leave the script out.
int isSkipped(lua_State* L) {
  const auto& skipped = Host::of(L).settings.skipped;
  const auto script = InstanceId(luaL_checknumber(L, 1));
  lua_pushboolean(L, std::find(skipped.begin(), skipped.end(), script) != skipped.end());
  return 1;
}

int rig(lua_State* L) {
  lua_pushstring(L, Host::of(L).settings.rig.c_str());
  return 1;
}

constexpr luaL_Reg kFunctions[] = {{"rawType", rawType},
                                   {"metatableOf", metatableOf},
                                   {"try", tryCall},
                                   {"spend", spend},
                                   {"newId", newId},
                                   {"enter", enter},
                                   {"timedOut", timedOut},
                                   {"newOwner", newOwner},
                                   {"load", load},
                                   {"where", where},
                                   {"functionHash", functionHash},
                                   {"refused", refused},
                                   {"rawLength", rawLength},
                                   {"setStringMethods", setStringMethods},
                                   {"copyList", copyList},
                                   {"rig", rig},
                                   {"isSkipped", isSkipped},
                                   {"isNative", isNative},
                                   {nullptr, nullptr}};

}  // namespace
}  // namespace script_functions

void registerScriptFunctions(lua_State* L) {
  luaL_register(L, nullptr, script_functions::kFunctions);
  lua_getglobal(L, "coroutine");
  lua_getfield(L, -1, "resume");
  lua_pushvalue(L, -1);
  lua_pushcclosure(L, script_functions::runThread, 1);
  lua_setfield(L, -4, "runThread");
  lua_pushcclosure(L, script_functions::resume, 1);
  lua_setfield(L, -2, "resume");
  lua_setfield(L, -2, "coroutine");
  lua_getglobal(L, "unpack");
  lua_setfield(L, -2, "unpack");
  luau::pushHelpers(L);
  lua_setfield(L, -2, "helpers");
}

}  // namespace obby::engine
