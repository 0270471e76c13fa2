#include "engine/host.h"

#include <cstdlib>

#include "engine/embedded.h"
#include "engine/values/values.h"

namespace obby::engine {
namespace {

constexpr const char* kModules = "obby.modules";

int useFunction(lua_State* L) { return Host::of(L).use(L, luaL_checkstring(L, 1)); }

}  // namespace

InstanceId Host::scriptOf(const char* source) {
  if (source[0] != '=' || source[1] != '#') return kNoInstance;
  return InstanceId(std::strtoul(source + 2, nullptr, 10));
}

Host::Host(const Document& documentIn, const Settings& settingsIn)
    : document(documentIn),
      settings(settingsIn),
      classes(ClassTable::get()),
      vm(settingsIn.budget, this),
      random(settingsIn.seed, settingsIn.draws) {
  owners.push_back(kNoInstance);
  lua_State* const L = vm.state();
  luaL_openlibs(L);
  openVector3(L);
  openCFrame(L);
  lua_newtable(L);
  lua_setfield(L, LUA_REGISTRYINDEX, kModules);
  lua_newtable(L);
  registerClassFunctions(L);
  registerSceneryFunctions(L);
  registerRecordFunctions(L);
  registerScriptFunctions(L);
  registerValueFunctions(L);
  registerByteFunctions(L);
  lua_setglobal(L, "host");
  lua_pushcfunction(L, useFunction);
  lua_setglobal(L, "use");
}

int Host::use(lua_State* L, const std::string& name) {
  lua_getfield(L, LUA_REGISTRYINDEX, kModules);
  lua_getfield(L, -1, name.c_str());
  if (lua_isnil(L, -1)) {
    lua_pop(L, 1);
    const std::string_view text = embeddedFile(name);
    if (text.empty()) return luaL_error(L, "the engine's runtime lacks the file %s", name.c_str());
    if (luaL_loadbuffer(L, text.data(), text.size(), ("=" + name).c_str()) != 0) lua_error(L);
    lua_call(L, 0, 1);
    lua_pushvalue(L, -1);
    lua_setfield(L, -3, name.c_str());
  }
  lua_remove(L, -2);
  return 1;
}

void Host::noteError(InstanceId script, std::string_view text) {
  if (text.find("Script timeout") != std::string_view::npos) limited.insert(slow = script);
  if (text.find("not enough memory") == std::string_view::npos || greedy != kNoInstance) return;
  greedy = script != kNoInstance ? script : slow != kNoInstance ? slow : owners[running];
}

Line Host::where(lua_State* L) const {
  lua_Debug at;
  for (int level = 0; lua_getstack(L, level, &at) != 0; ++level) {
    lua_getinfo(L, "Sl", &at);
    const InstanceId script = scriptOf(at.source);
    if (script != kNoInstance) return {script, at.currentline};
  }
  return {owners[running], 0};
}

std::string Host::withNames(std::string text) const {
  size_t at = 0;
  while ((at = text.find('#', at)) != std::string::npos) {
    char* end = nullptr;
    const auto id = InstanceId(std::strtoul(text.c_str() + at + 1, &end, 10));
    const size_t length = size_t(end - text.c_str()) - at;
    if (length > 1 && *end == ':' && id < document.instances.size()) {
      const std::string& name = document.instances[id].name;
      text.replace(at, length, name);
      at += name.size();
    } else {
      ++at;
    }
  }
  return text;
}

}  // namespace obby::engine
