// Parses arbitrary bytes as a Luau script. A script without syntax errors becomes Lua 5.1 text that
// the VM compiles, unless it exceeds the VM's limits.
#include <cstddef>
#include <cstdint>
#include <lua.hpp>
#include <string_view>

#include "engine/luau/emit.h"
#include "engine/luau/parser.h"

namespace {

bool isLimit(std::string_view message) {
  for (const std::string_view words :
       {"has more than", "too many", "too complex", "too long", "overflow", "not enough memory"})
    if (message.find(words) != std::string_view::npos) return true;
  return false;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view source(reinterpret_cast<const char*>(data), size);
  const auto chunk = obby::luau::parse(source);
  if (chunk.broken != !chunk.error.empty()) __builtin_trap();
  const auto lua = obby::luau::emit(chunk);
  if (!lua) return 0;
  if (chunk.broken || lua->find('\0') != std::string_view::npos) __builtin_trap();
  lua_State* const state = luaL_newstate();
  const bool loads = luaL_loadbuffer(state, lua->data(), lua->size(), "=fuzz") == 0;
  if (!loads && !isLimit(lua_tostring(state, -1))) __builtin_trap();
  lua_close(state);
  return 0;
}
