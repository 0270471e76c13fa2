// Numbers as text, and edge cases of the helpers.
#include "engine/luau/helpers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/lua_runner.h"
#include "engine/luau/number_text.h"

namespace obby::test {
namespace {

TEST(NumberText, IsTheShortestThatReadsBack) {
  const std::pair<double, const char*> cases[] = {{0, "0"},
                                                  {-0.0, "-0"},
                                                  {100, "100"},
                                                  {-1.5, "-1.5"},
                                                  {0.1, "0.1"},
                                                  {1.0 / 3, "0.3333333333333333"},
                                                  {1e15, "1000000000000000"},
                                                  {1e20, "100000000000000000000"},
                                                  {1e21, "1e+21"},
                                                  {1.25e22, "1.25e+22"},
                                                  {1e-6, "0.000001"},
                                                  {1e-7, "1e-07"},
                                                  {5e-324, "5e-324"},
                                                  {9007199254740993, "9007199254740992"},
                                                  {INFINITY, "inf"},
                                                  {-INFINITY, "-inf"},
                                                  {NAN, "nan"},
                                                  {-NAN, "nan"}};
  for (const auto& [value, text] : cases) EXPECT_EQ(luau::numberText(value), text);
}

TEST(Helpers, MetamethodResultsAreCutToOneValue) {
  const auto outcome = LuaRunner().run(
      "local two = {__len = function() return 1, 2 end, __idiv = function() return 1, 2 end, "
      "__concat = function() return 1, 2 end}\nlocal t = setmetatable({}, two)\n"
      "print(#t)\nprint(t // 1)\nprint(t .. 1)\nprint(select('#', #t, t // 1, t .. 1))");
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.printed, "1\n1\n1\n3\n");
}

TEST(Helpers, MetatablesNameTypes) {
  const auto outcome = LuaRunner().run(
      "local part = setmetatable({}, {__type = 'Instance'})\nprint(pcall(function() return part .. "
      "'x' end))\nprint(pcall(function() return part // 1 end))");
  EXPECT_EQ(outcome.printed,
            "false script:2: attempt to concatenate Instance with string\n"
            "false script:3: attempt to perform arithmetic (idiv) on Instance and number\n");
}

// A runtime may replace the functions that order tables and convert values to text.
TEST(Helpers, UseTheRuntimesTextAndOrder) {
  lua_State* const state = luaL_newstate();
  luau::pushHelpers(state);
  const lua_CFunction mine = [](lua_State* s) {
    lua_pushliteral(s, "mine");
    return 1;
  };
  lua_pushcfunction(state, mine);
  lua_setfield(state, -2, "tostring");
  lua_getfield(state, -1, "interp");
  lua_newtable(state);
  lua_pushnumber(state, 0.5);
  lua_call(state, 2, 1);
  EXPECT_STREQ(lua_tostring(state, -1), "mine0.5");
  lua_pop(state, 1);
  lua_pushliteral(state, "order");
  lua_setfield(state, -2, "next");
  lua_getfield(state, -1, "iter");
  lua_newtable(state);
  lua_call(state, 1, 3);
  EXPECT_STREQ(lua_tostring(state, -3), "order");
  lua_close(state);
}

}  // namespace
}  // namespace obby::test
