// The Luau parser accepts the language's grammar.
#include <gtest/gtest.h>

#include "engine/luau/parser.h"

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
      "goto = 1 type = 2 continue = 3"};
  for (const char* text : texts) EXPECT_FALSE(luau::parse(text).broken) << text;
}

}  // namespace
}  // namespace obby::test
