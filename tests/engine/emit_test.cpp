// Runs each construct of Luau's grammar as Lua 5.1. Longer programs are in luau/; oracle.mjs
// compares them with Luau's own VM, too.
#include "engine/luau/emit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "engine/lua_runner.h"

namespace obby::test {
namespace {

struct Case {
  const char* name;
  const char* source;
  const char* printed;  // expected output, without the last line break
};

void PrintTo(const Case& value, std::ostream* out) { *out << value.name; }

class Construct : public testing::TestWithParam<Case> {};

TEST_P(Construct, Runs) {
  const auto outcome = LuaRunner().run(GetParam().source);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.printed, std::string(GetParam().printed) + "\n");
}

const Case kStatements[] = {
    {"Local", "local a, b: number, c = 1, 2 print(a, b, c)", "1 2 nil"},
    {"LocalAttributes",
     "@native @[deprecated {use='g'}] local function f() return 1 end print(f())", "1"},
    {"Const", "const a, b = 1, 2 const function f() return a + b end print(f())", "3"},
    {"Assign", "a, b = 1 print(a, b)", "1 nil"},
    {"AssignLeftToRight", "local t = {} t.a, t.a = 1, 2 print(t.a)", "2"},
    {"AssignKeepsObjectsAndKeys", "local i, t = 1, {} i, t[i] = 5, 6 print(i, t[1], t[5])",
     "5 6 nil"},
    {"Compound", "local a, t = 8, {x = 2} a -= 1 t.x ^= 3 t['x'] //= 3 a ..= t.x print(a, t.x)",
     "72 2"},
    {"CompoundOnce",
     "local n, t = 0, {5} local function f() n += 1 return t end f()[n] += 1 "
     "print(n, t[1])",
     "1 6"},
    {"CompoundReadsFirst", "a = 1 local function f() a = 10 return 1 end a += f() print(a)", "2"},
    {"Call", "print'x' print[[y]] local function f(t) print(t[1]) end f{3}", "x\ny\n3"},
    {"While", "local i = 0 while i < 3 do i += 1 end print(i)", "3"},
    {"Repeat", "local i = 0 repeat local j = i i += 1 until j == 3 print(i)", "4"},
    {"RepeatContinue",
     "local i = 0 repeat local j = i i += 1 if j < 9 then continue end until j "
     "== 3 print(i)",
     "4"},
    {"NumericFor", "for i = 3, 1, -2 do print(i) end", "3\n1"},
    {"GenericFor", "for k, v in pairs({5}) do print(k, v) end", "1 5"},
    {"ForTable", "for k, v in {5} do print(k, v) end", "1 5"},
    {"ForIter",
     "for v in setmetatable({}, {__iter = function() return next, {x = 1} end}) do "
     "print(v) end",
     "x"},
    {"ForCallable",
     "for v in setmetatable({}, {__call = function(_, _, i) return not i or nil "
     "end}) do print(v) end",
     "true"},
    {"Continue", "for i = 1, 3 do if i == 2 then continue end print(i) end", "1\n3"},
    {"Break", "for i = 1, 9 do if i == 1 then continue elseif i == 3 then break end print(i) end",
     "2"},
    {"If", "if nil then print(1) elseif false then print(2) else print(3) end", "3"},
    {"Do", "local a = 1 do local a = 2 print(a) end print(a)", "2\n1"},
    {"Function",
     "local o = {p = {}} function o.p.f(...) return ... end function o.p:g() return "
     "self == o.p end print(o.p.f(1, 2), o.p:g())",
     "1 true"},
    {"LocalFunction", "local function f(n) return n < 2 and 1 or n * f(n - 1) end print(f(5))",
     "120"},
    {"Return", "local function f() return 1, 2 end print((f()), f()) return 5", "1 1 2"},
    {"Types", "type A<T, U... = ()> = {[T]: (U...) -> ()} export type B = typeof(1)? print(1)",
     "1"},
    {"TypeFunction", "type function f(t) return t end print(f)", "nil"},
    {"Semicolons", "local a = 1; print(a); do end; print(2)", "1\n2"},
    {"Bracket", "local t = {}; (print)(1); (t).x = 2; (print)(t.x)", "1\n2"},
};

const Case kExpressions[] = {
    {"Numbers", "print(0b11, 0xfF, 1_0.5, 1e2, .5)", "3 255 10.5 100 0.5"},
    {"Infinity", "print(1e999, -1e999)", "inf -inf"},
    {"NegativeZero", "print(1 / 0, 1 / -0, -0)", "inf -inf -0"},
    {"Exact", "print(0.1 + 0.2, 2^53 + 1, 1/3)",
     "0.30000000000000004 9007199254740992 0.3333333333333333"},
    {"Escapes", R"(print("\65\x42\u{43}\z   D\"\'\\"))", "ABCD\"'\\"},
    {"LongString", "print([==[\na]]b\n]==])", "a]]b\n"},
    {"Interpolation", "print(`a{1}{`b{'c'}`}\\{`)", "a1bc{"},
    {"InterpolationOne", "local function f() return 1, 2 end print(`{f()}`, `{f()}x`)", "1 1x"},
    {"Varargs", "local function f(...) return select('#', ...), (...) end print(f(7, 8), f())",
     "2 0 nil"},
    {"ScriptVarargs", "print(select('#', ...), (...))", "0 nil"},
    {"FloorDivision", "print(7 // 2, -7 // 2, '9' // 2)", "3 -4 4"},
    {"Length", "print(#'abc', #{1, 2}, #setmetatable({}, {__len = function() return 9 end}))",
     "3 2 9"},
    {"Concatenation", "print(1 .. 2 .. 0.1, 'a' .. 'b')", "120.1 ab"},
    {"Unary", "print(-2 ^ 2, not nil, - -3, -'2')", "-4 true 3 -2"},
    {"Choice", "print(if 1 then 'a' else 'b', if nil then 1 elseif 2 then nil else 3)", "a nil"},
    {"ChoiceOfMany", "local function f(...) return if ... then ... else 0, 'x' end print(f(1, 2))",
     "1 x"},
    {"ChoiceInside", "local x = 1 + if x then 1 else 2 * 3 print(x)", "7"},
    {"Cast", "local function f() return 1, 2 end print(f() :: any) print(1 :: number + 1)", "1\n2"},
    {"Instantiation", "local function f<T>(x: T): T return x end print(f<<number>>(1))", "1"},
    {"Table", "local t = {1; 2, x = 3, ['y'] = 4, [5] = 6,} print(#t, t.x, t.y, t[5])", "2 3 4 6"},
    {"Methods", "print(('x'):rep(2), ('%d'):format(3))", "xx 3"},
    {"Function", "print((function<T>(a: T, ...: T): T return a end)(4))", "4"},
    {"AttributeFunction", "print((@native function() return 4 end)())", "4"},
    {"Prefix", "local L_, L1_ = 1, 2 L_ += #{1} print(L_, L1_)", "2 2"},
    {"ContextualNames",
     "local continue, type, export, const = 1, 2, 3, 4 continue += 1 print("
     "continue, type, export, const)",
     "2 2 3 4"},
};

const auto nameOf = [](const testing::TestParamInfo<Case>& info) {
  return std::string(info.param.name);
};
INSTANTIATE_TEST_SUITE_P(Statements, Construct, testing::ValuesIn(kStatements), nameOf);
INSTANTIATE_TEST_SUITE_P(Expressions, Construct, testing::ValuesIn(kExpressions), nameOf);

// Returns `text` repeated. Tests use it for nesting, locals or upvalues that are within Luau's
// limits but beyond those of Lua 5.1.
std::string repeated(int count, const char* text) {
  std::string all;
  for (int i = 0; i < count; ++i) {
    std::string one = text;
    for (size_t at; (at = one.find('#')) != std::string::npos;)
      one.replace(at, 1, std::to_string(i));
    all += one;
  }
  return all;
}

TEST(EmitLimits, ManyCapturedVariables) {
  const std::string source =
      "local fs = {} for round = 1, 2 do " + repeated(120, "local v# = round * # ") +
      "fs[round] = function() local s = 0 " + repeated(120, "v# += 1 s += v# ") +
      "return s end end " + "print(fs[1](), fs[2](), fs[1]())";
  const auto outcome = LuaRunner().run(source);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.printed, "7260 14400 7380\n");
}

TEST(EmitLimits, ManyLocalVariables) {
  const std::string source = repeated(199, "local v# = # ") +
                             "for i = 1, 2 do for _, w in {1} do v0 += w continue end end "
                             "print(v0, v198)";
  const auto outcome = LuaRunner().run(source);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.printed, "2 198\n");
}

TEST(EmitLimits, LongChains) {
  const std::string source = "local x = 1 print(#(x" + repeated(300, " .. x") + "), x" +
                             repeated(800, " + x") + ", #`" + repeated(300, "{x}") + "`)";
  const auto outcome = LuaRunner().run(source);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.printed, "301 801 300\n");
}

TEST(EmitLimits, DeepNesting) {
  const std::string source = repeated(120, "if true then ") + "print(#) " + repeated(120, "end ") +
                             "print(" + repeated(70, "(") + "1" + repeated(70, ")") + ")";
  std::string plain = source;
  plain.replace(plain.find("print(#)"), 8, "print(0)");
  const auto outcome = LuaRunner().run(plain);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.printed, "0\n1\n");
}

TEST(Emit, IsTheSameEachTime) {
  const std::string source = repeated(150, "local v# = # ") + "local function f() return " +
                             repeated(149, "v# + ") + "v149 end print(f())";
  const auto first = luau::toLua(source);
  ASSERT_TRUE(first);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(*luau::toLua(source), *first);
}

// If the VM raises an error, its line is that of the Luau script.
TEST(Emit, ErrorsHaveTheScriptsLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"local a = 1\n\nerror('x')", "script:3: x"},
      {"local s = [[\n\n]]\nerror(`a\\\nb`)", "script:4: a\nb"},
      {"type A = {\n  x: number,\n}\nlocal t: A = nil\nt.x = 1", "script:5: "},
      {"for i = 1, 2 do\n  if i == 1 then continue end\n  error(i, 1)\nend", "script:3: 2"},
      {"local n = nil\nprint(\n  1,\n  #n)", "script:4: attempt to get length of a nil value"},
      {"local n\nlocal x = 1\n  // n",
       "script:2: attempt to perform arithmetic (idiv) on number and nil"},
      {"local n = 'a' .. nil", "script:1: attempt to concatenate string with nil"},
      {"\nfor x in 5 do\nend", "script:2: attempt to iterate over a number value"},
      {"\nlocal n, f = nil, print\nn.x = f(\n  1,\n  2\n)", "script:3: "},
      {"local t = setmetatable({}, {__newindex = function() error('set', 2) end})\nt.x = if t\n"
       "  then 1\n  else {\n    2\n  }",
       "script:2: set"},
      {"local n, f = nil, print\nprint(1)\nlocal t = {}\nt.x = f(\n  n.x\n)", "script:4: "},
      {"local t = {}\nt.x = print(\n  1,\n  error('deep')\n)", "script:4: deep"},
      {"local t = {}\nt.x += (\n  error('deep'))", "script:3: deep"},
      {"local t = {}\nt.x = function()\n  error('body')\nend\nt.x()", "script:3: body"},
      {"local function f() return\n  g() end\nf()", "script:2: "},
      {"local function f() return #nil end\nf()", "script:1: attempt to get length"}};
  for (const auto& [source, error] : cases) {
    const auto outcome = LuaRunner().run(source);
    EXPECT_EQ(outcome.error.substr(0, std::string_view(error).size()), error) << source;
  }
}

TEST(Emit, CallsAreNeverTailCalls) {
  const auto outcome = LuaRunner().run(
      "local function check() error('bad', 2) end\nlocal function user()\n  return check()\nend\n"
      "user()");
  EXPECT_EQ(outcome.error, "script:3: bad");
}

TEST(Emit, RefusesAssignmentsToConstants) {
  for (const char* source : {"const a = 1\na = 2", "const a = 1\na += 2",
                             "const a = 1\nfunction a() end", "const a = 1 do\nb, a = 1 end"}) {
    const auto lua = luau::toLua(source);
    ASSERT_FALSE(lua) << source;
    EXPECT_EQ(lua.error().message, "'a' is a constant: it cannot be assigned to");
    EXPECT_EQ(lua.error().place, "2");
  }
  EXPECT_TRUE(luau::toLua("const a = {} a.x = 1 do local a = 1 a = 2 end"));
}

TEST(Emit, ContinueMayNotSkipAVariableOfTheCondition) {
  const auto skips = luau::toLua("repeat\nif a then continue end\nlocal b = 1\nuntil b");
  ASSERT_FALSE(skips);
  EXPECT_EQ(skips.error().message,
            "the 'continue' of line 2 skips 'b', which the loop's condition needs");
  EXPECT_EQ(skips.error().place, "4");
  for (const char* source : {"repeat local b = 1 if a then continue end until b",
                             "repeat for i = 1, 2 do continue end local b = 1 until b",
                             "local b repeat if a then continue end do local b = 1 end until b"})
    EXPECT_TRUE(luau::toLua(source)) << source;
}

TEST(Emit, KeepsStatementsOnTheirLines) {
  const auto lua = luau::toLua("local a = 1\n\n-- comment\nprint(\n  a,\n  2\n)\nlocal b");
  ASSERT_TRUE(lua);
  EXPECT_EQ(*lua, "local L_=...;local a=1;\n\n\nprint(\na,\n2);\n\nlocal b;");
}

// The corpus runs without errors. oracle.mjs checks that it prints what Luau prints.
TEST(Emit, ProgramsRun) {
  size_t count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(OBBY_SOURCE_DIR "/tests/engine/luau")) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string source((std::istreambuf_iterator<char>(file)), {});
    EXPECT_EQ(LuaRunner().run(source).error, "") << entry.path();
    ++count;
  }
  EXPECT_GE(count, 60u);
}

}  // namespace
}  // namespace obby::test
