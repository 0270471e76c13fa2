// The Luau parser accepts all of the language's grammar, and reports errors in plain words.
#include "engine/luau/parser.h"

#include <gtest/gtest.h>

#include <string>

namespace obby::test {
namespace {

TEST(Parser, ModernAndOldSyntaxParses) {
  const char* const texts[] = {
      "local x: number, y: {[string]: Part?} = 5, {}\nexport type A = {b: (number) -> string}",
      "local function f<T>(a: T, ...: any): (number, T) return 1, a end",
      "x += 1 y ..= 'a' z //= 2",
      "for i, v in t do continue end",
      "local s = `a {1 + 2} b` local l = [==[ ]] ]==] --[[ c ]] --[=[ d ]=]",
      "local a = if b then c elseif d then e else f",
      "f{a = 1, [2] = 3; 4} f'x' f[[y]] a.b:c(1)(2).d = 3",
      "repeat local x = f() until x or not y",
      "local n = 0xFF + 1e-3 + .5 + 1_000 + 0b1",
      "local p = workspace.Part :: BasePart",
      "goto = 1 type = 2 continue = 3",
      "type T = | 'a' | \"b\" | nil type U = A.B<C, D...> & {E}?",
      "type F = <T, U...>(a: T, b: T?, ...number) -> (...T) -> U...",
      "type G<A, B = A, C... = (number, ...string), D... = ...any> = (A) -> C...",
      "type R = {read x: number, write [string]: number, read: any; write: any, [true]: nil}",
      "local f: typeof(a.b(c)) | (() -> ())? = nil :: any",
      "@native @[deprecated {use = 'x'}, checked] function f() end",
      "local y = f<<number, {string}>>(1) local z = o:m<<T...>>(2)",
      "export type function f(a) return a end const c, d: number = 1, 2",
      "type = type type(x) export = 5 export.x = 1 const(1) continue:f()"};
  for (const char* text : texts) {
    const auto chunk = luau::parse(text);
    EXPECT_FALSE(chunk.broken) << text << ": " << chunk.error;
  }
}

struct Wrong {
  const char* source;
  int line;
  const char* error;
};

const Wrong kWrong[] = {
    {"local function f()\nprint(1)", 2,
     "expected 'end' to close 'function' of line 1, found '<end of file>'"},
    {"while x do\nif y then\nend", 3,
     "expected 'end' to close 'while' of line 1, found '<end of file>'"},
    {"repeat\nlocal a = 1\nend", 3, "expected 'until' to close 'repeat' of line 1, found 'end'"},
    {"x = {\n1,\n2\nlocal y", 4, "expected '}' to close '{' of line 1, found 'local'"},
    {"print(1\nx = 2", 2, "expected ')' to close '(' of line 1, found 'x'"},
    {"x = y[1", 1, "expected ']' to close '[' of line 1, found '<end of file>'"},
    {"if x\nprint(1) end", 2, "expected 'then', found 'print'"},
    {"for i = 1 do end", 1, "expected ',' and the last value of the loop, found 'do'"},
    {"for i, j = 1, 2 do end", 1, "expected 'in', found '='"},
    {"for i = 1, 2, 3, 4 do end", 1, "'for' takes only a first value, a last value and a step"},
    {"print(1))", 1, "expected a statement, found ')'"},
    {"end", 1, "expected '<end of file>', found 'end'"},
    {"x = = 1", 1, "expected an expression, found '='"},
    {"x = 1 +", 1, "expected an expression, found '<end of file>'"},
    {"local 5 = 1", 1, "expected a name, found '5'"},
    {"local a.b = 1", 1, "expected a statement, found '.'"},
    {"x", 1, "incomplete statement: expected an assignment or a call, found '<end of file>'"},
    {"(f())", 1, "incomplete statement: expected an assignment or a call, found '<end of file>'"},
    {"f() = 1", 1, "only a variable or a field can be assigned to"},
    {"(a) = 1", 1, "only a variable or a field can be assigned to"},
    {"a, f() = 1", 1, "only a variable or a field can be assigned to"},
    {"a, b += 1", 1, "expected '=', found '+='"},
    {"local f = g\n(h)()", 2,
     "'(' on a new line could begin a statement or a call: put ';' before it to begin a statement"},
    {"return 1 print(2)", 1, "expected the end of the block after 'return', found 'print'"},
    {"while true do break print(2) end", 1,
     "expected the end of the block after 'break', found 'print'"},
    {"break", 1, "'break' outside of a loop"},
    {"while true do local function f() continue end end", 1, "'continue' outside of a loop"},
    {"function f() return ... end", 1, "'...' is used in a function that does not take it"},
    {"x = 'abc\ny'", 1, "malformed string: its closing quote is missing on this line"},
    {"x = '\\xZZ'", 1, "malformed escape in a string"},
    {"x = '\\300'", 1, "malformed escape in a string"},
    {"x = '\\u{110000}'", 1, "malformed escape in a string"},
    {"x = `a{1`", 1, "malformed string: its closing quote is missing on this line"},
    {"x = `a\\\nb{1\ny = 2", 3,
     "expected '}' to continue the string that starts on line 1, found 'y'"},
    {"x = `a{}`", 1, "expected an expression inside '{}', found a string"},
    {"x = `{{1}}`", 1, "'{{' in an interpolated string: write '\\{'"},
    {"f`x`", 1, "incomplete statement: expected an assignment or a call, found a string"},
    {"x = [[abc", 1, "this long string has no end"},
    {"x = 1\n--[[ abc", 2, "this comment has no end"},
    {"x = 1..2", 1, "malformed number"},
    {"x = 0x1p4", 1, "malformed number"},
    {"x = 3abc", 1, "malformed number"},
    {"x = 'a':rep(2)", 1, "expected a statement, found ':'"},
    {"x = $", 1, "expected an expression, found '$'"},
    {"x != 1", 1, "incomplete statement: expected an assignment or a call, found '!'"},
    {"x = \xC2\xA0y", 1, "expected an expression, found a byte of value 194"},
    {"x = if a then b", 1, "expected 'else' of the 'if' expression, found '<end of file>'"},
    {"local x <const> = 1", 1, "expected a statement, found '<'"},
    {"const x", 1, "expected '=' and the value of a constant, found '<end of file>'"},
    {"@native local x = 1", 1, "expected 'function' after an attribute, found 'x'"},
    {"type A = 5", 1, "expected a type, found '5'"},
    {"local x: A<B = 1", 1, "expected '>' to close '<' of line 1, found '='"},
    {"x.y:z = 1", 1, "expected '(', '{' or a string as the arguments of a call, found '='"},
    {"goto x", 1, "incomplete statement: expected an assignment or a call, found 'x'"},
};

TEST(Parser, TheFirstErrorHasItsLine) {
  for (const Wrong& wrong : kWrong) {
    const auto chunk = luau::parse(wrong.source);
    EXPECT_TRUE(chunk.broken) << wrong.source;
    EXPECT_EQ(chunk.error, wrong.error) << wrong.source;
    EXPECT_EQ(chunk.errorLine, wrong.line) << wrong.source;
  }
}

TEST(Parser, NestingIsBounded) {
  const auto nested = [](const char* open, const char* close, int count) {
    std::string text = "x = ";
    for (int i = 0; i < count; ++i) text += open;
    text += "1";
    for (int i = 0; i < count; ++i) text += close;
    return luau::parse(text).error;
  };
  for (const auto& [open, close] :
       {std::pair("(", ")"), std::pair("{", "}"), std::pair("- ", ""), std::pair("`{", "}`"),
        std::pair("1^", ""), std::pair("if 1 then 1 else ", "")}) {
    EXPECT_EQ(nested(open, close, 40), "") << open;
    EXPECT_EQ(nested(open, close, 20'000), "the code is nested too deeply") << open;
  }
  EXPECT_EQ(nested("1 + ", "", 900), "");
  EXPECT_EQ(nested("1 + ", "", 20'000), "this expression is too long");
  EXPECT_EQ(nested("1 .. ", "", 900), "");
  EXPECT_EQ(nested("1 .. ", "", 20'000), "this expression is too long");
}

// Statements after an error are kept.
TEST(Parser, KeepsUnparsedText) {
  const auto chunk = luau::parse("x = 1\ny = = 2\nend\nz = 3");
  EXPECT_TRUE(chunk.broken);
  ASSERT_FALSE(chunk.body.empty());
  EXPECT_EQ(chunk.body.front()->line, 1);
  EXPECT_EQ(chunk.body.back()->line, 4);
}

}  // namespace
}  // namespace obby::test
