// Scripts that evade the instruction budgets must not harm the process.
#include <gtest/gtest.h>

#include "engine/place.h"

namespace obby::test {
namespace {

engine::Settings small() {
  engine::Settings settings;
  settings.budget = {.memory = size_t(32) << 20, .instructions = 3'000'000, .stretch = 300'000};
  return settings;
}

// Runs a place with one script for a second. Returns the problems of its scripts.
std::string problemsOf(const std::string& source) {
  Place place;
  place.script(source, place.scripts);
  engine::Stage stage(place.document, small());
  stage.start();
  stage.run(60);
  stage.made();
  stage.probes();
  return problems(stage.observation());
}

TEST(Budget, HostCallsEndWhenMemoryIsExhausted) {
  EXPECT_NE(problemsOf("_G.t = {} local t = _G.t while true do t[#t + 1] = {} end"), "");
  EXPECT_NE(problemsOf("game:GetService('RunService').Heartbeat:Connect(function()\n"
                       "  _G.t = {_G.t, table.create(20000, 1)}\nend)\n"
                       "while true do _G.s = {_G.s} end"),
            "");
}

TEST(Budget, ThreadsInThreadsEnd) {
  problemsOf("local function f() pcall(f) end f()");
  problemsOf("local function f() xpcall(f, print) end f()");
  // Each thread makes many nested calls from C.
  problemsOf(
      "local function f(n)\n"
      "  string.gsub('a', 'a', function() if n > 0 then f(n - 1) else coroutine.wrap(f)(180) end "
      "end)\nend f(180)");
}

TEST(Budget, NativeFunctionsAreCalledInThreads) {
  EXPECT_EQ(problemsOf("assert(not pcall(error, 'x') and select(2, pcall(math.max, 1, 2)) == 2)\n"
                       "assert(coroutine.wrap(math.max)(1, 2) == 2)\n"
                       "local f = coroutine.wrap(coroutine.yield) f(1) assert(f(2) == 2)\n"
                       "spawn(print) task.spawn(math.abs, 1) task.defer(tostring, 1)"),
            "");
  EXPECT_NE(problemsOf("task.spawn(error, 'told')").find("told"), std::string::npos);
}

TEST(Budget, PatternsOfManyItemsAreErrors) {
  const std::string seen = problemsOf("string.find('x', string.rep('a?', 200000))");
  EXPECT_NE(seen.find("pattern too complex"), std::string::npos) << seen;
  EXPECT_EQ(problemsOf("assert(string.find('x', string.rep('a?', 50)) == 1)\n"
                       "assert(string.find('x', string.rep('?', 500), 1, true) == nil)\n"
                       "assert(('a'):gsub(string.rep('a', 500), '') == 'a')"),
            "");
}

TEST(Budget, ProxiesHaveNoFinalizers) {
  EXPECT_EQ(problemsOf("for i = 1, 100 do\n"
                       "  local meta = getmetatable(newproxy(true))\n"
                       "  meta.__gc = function() while true do end end\n"
                       "  assert(meta.__gc == nil and not pcall(rawset, meta, '__gc', print))\n"
                       "  meta.__index = function(_, key) return key end\nend\n"
                       "local p = newproxy(true) getmetatable(p).__len = function() return 3 end\n"
                       "assert(#p == 3 and typeof(p) == 'userdata')\n"
                       "assert(type(getmetatable(Vector3.zero)) == 'string')\n"
                       "assert(type(getmetatable('')) == 'string')"),
            "");
}

TEST(Budget, RejectsOtherValuesInPlaceOfARandom) {
  const std::string seen = problemsOf(
      "local r = Random.new(1) r[1] = newproxy() assert(not pcall(r.NextNumber, r))\n"
      "r[1] = Vector3.zero assert(not pcall(r.NextNumber, r))");
  EXPECT_EQ(seen, "");
}

TEST(Budget, AcceptsAnyNumberAsAnInteger) {
  EXPECT_EQ(
      problemsOf("for _, x in {-1e308, 1e308, 0 / 0, 1 / 0, -1} do\n"
                 "  Random.new(x):NextNumber() bit32.band(x) BrickColor.new(x)\n"
                 "  pcall(BrickColor.palette, x)\n"
                 "  game:GetService('TweenService'):Create(workspace.Spawn,\n"
                 "    TweenInfo.new(1, Enum.EasingStyle.Linear, Enum.EasingDirection.In, x),\n"
                 "    {Transparency = 1}):Play()\nend\n"
                 "assert(bit32.band(-1) == 4294967295)"),
      "");
}

TEST(Budget, AcceptsAnyNumberAsAShift) {
  EXPECT_EQ(problemsOf("assert(bit32.rshift(1, -2147483648) == 0)\n"
                       "assert(bit32.arshift(1, -2147483648) == 0)\n"
                       "assert(bit32.lshift(1, 1e300) == 0 and bit32.rshift(6, 1) == 3)\n"
                       "assert(bit32.arshift(0x80000000, 31) == 0xffffffff)\n"
                       "assert(bit32.extract(0xabcd, 4, 8) == 0xbc)\n"
                       "assert(not pcall(bit32.extract, 1, 2147483647))"),
            "");
}

TEST(Budget, AcceptsAnyNumberAsADate) {
  EXPECT_EQ(
      problemsOf("assert(os.time({year = 2020, month = 1, day = 1, hour = 0}) == 1577836800)\n"
                 "os.time({year = -2147483648, month = -2147483648, day = 1, sec = 1e300})\n"
                 "assert(os.date('*t', 0).year == 1970)\n"
                 "for _, when in {6.7e16, 6.776e16, -1e300, 0 / 0} do\n"
                 "  os.date('*t', when) os.date('%c', when)\nend"),
      "");
}

TEST(Budget, ReportedTextIsBounded) {
  Place place;
  place.script(
      "for i = 1, 5000 do task.spawn(error, string.rep('x', 5000) .. i) end\n"
      "for i = 1, 5000 do task.spawn(error, i .. ' y') end",
      place.scripts);
  place.script(
      "local s = string.rep('x', 4e6)\n"
      "for i = 1, 1000 do workspace.Spawn.CollisionGroup = s .. i % 2 end",
      place.scripts);
  engine::Settings settings;
  settings.budget.memory = size_t(64) << 20;
  engine::Stage stage(place.document, settings);
  stage.start();
  stage.run(60);
  const engine::Observation& seen = stage.observation();
  size_t text = 0;
  for (const engine::Problem& problem : seen.problems) text += problem.text.size();
  for (const engine::Change& change : seen.changes)
    if (const auto* const value = std::get_if<std::string>(&change.value)) text += value->size();
  EXPECT_LE(seen.problems.size(), 500u);
  EXPECT_LT(text, size_t(80) << 20);
}

}  // namespace
}  // namespace obby::test
