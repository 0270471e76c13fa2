// luau_run FILE: runs a Luau program. Its output goes to stdout, its error to stderr. With --lua,
// prints the emitted Lua 5.1 instead.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "engine/lua_runner.h"

int main(int argc, char** argv) {
  const bool textOnly = argc == 3 && std::string(argv[1]) == "--lua";
  std::ifstream file(argv[argc - 1], std::ios::binary);
  if (argc < 2 || !file) return 2;
  const std::string source((std::istreambuf_iterator<char>(file)), {});
  if (textOnly) {
    const auto lua = obby::luau::toLua(source);
    if (!lua) std::fprintf(stderr, "%s\n", lua.error().text().c_str());
    if (lua) std::fwrite(lua->data(), 1, lua->size(), stdout);
    return lua ? 0 : 1;
  }
  const auto outcome = obby::test::LuaRunner().run(source);
  std::fwrite(outcome.printed.data(), 1, outcome.printed.size(), stdout);
  if (!outcome.error.empty()) std::fprintf(stderr, "%s\n", outcome.error.c_str());
  return outcome.error.empty() ? 0 : 1;
}
