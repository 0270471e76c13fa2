// Runs a Luau text, emitted as Lua 5.1, in a VM with few libraries, and keeps its output.
#pragma once

#include <lua.hpp>
#include <string>
#include <string_view>

#include "engine/luau/emit.h"
#include "engine/luau/helpers.h"

namespace obby::test {

struct RunOutcome {
  std::string printed;  // lines; values are separated by blanks
  std::string error;    // error of the parser, the VM's compiler or the script
};

class LuaRunner {
 public:
  LuaRunner() : state_(luaL_newstate()) {
    for (const lua_CFunction open : {luaopen_base, luaopen_string, luaopen_table, luaopen_math}) {
      lua_pushcfunction(state_, open);
      lua_call(state_, 0, 0);
    }
    luau::pushHelpers(state_);
    lua_getfield(state_, -1, "tostring");
    lua_setglobal(state_, "tostring");
    lua_setfield(state_, LUA_REGISTRYINDEX, "helpers");
    lua_pushlightuserdata(state_, this);
    lua_pushcclosure(state_, print, 1);
    lua_setglobal(state_, "print");
  }
  ~LuaRunner() { lua_close(state_); }
  LuaRunner(const LuaRunner&) = delete;
  LuaRunner& operator=(const LuaRunner&) = delete;

  RunOutcome run(std::string_view source) {
    outcome_ = {};
    auto lua = luau::toLua(source);
    if (!lua) {
      outcome_.error = lua.error().place + ": " + lua.error().message;
      return outcome_;
    }
    if (luaL_loadbuffer(state_, lua->data(), lua->size(), "=script") != 0) {
      takeError();
      return outcome_;
    }
    lua_getfield(state_, LUA_REGISTRYINDEX, "helpers");
    if (lua_pcall(state_, 1, 0, 0) != 0) takeError();
    return outcome_;
  }

 private:
  void takeError() {
    const char* const text = lua_tostring(state_, -1);
    outcome_.error = text ? text : "(no text)";
    lua_pop(state_, 1);
  }

  static int print(lua_State* state) {
    auto* runner = static_cast<LuaRunner*>(lua_touserdata(state, lua_upvalueindex(1)));
    const int count = lua_gettop(state);
    lua_getglobal(state, "tostring");
    for (int i = 1; i <= count; ++i) {
      lua_pushvalue(state, count + 1);
      lua_pushvalue(state, i);
      lua_call(state, 1, 1);
      size_t size = 0;
      const char* const text = lua_tolstring(state, -1, &size);
      if (i > 1) runner->outcome_.printed += ' ';
      runner->outcome_.printed.append(text, size);
      lua_pop(state, 1);
    }
    runner->outcome_.printed += '\n';
    return 0;
  }

  lua_State* state_;
  RunOutcome outcome_;
};

}  // namespace obby::test
