// What emitted Lua (emit.h) calls. The table's fields, all functions unless said otherwise:
//
//   len(v)         #v: of a string its bytes; of what has __len, what that returns; of a table its
//                  border
//   idiv(a, b)     a // b: floor(a / b) of numbers and strings that are numbers; else __idiv
//   cat(a, ...)    a .. b ..., from the right, by __concat where an operand is neither string nor
//                  number; numbers as numberText() writes them
//   catn(n, list)  the same of list[1] .. list[n]
//   interp(...)    an interpolated string of its parts: strings as they are, numbers by
//                  numberText(), others by the field tostring
//   iter(a, b, c)  what `for ... in a, b, c` runs with: a function as it is; else what __iter of a
//                  returns; else a itself if it has __call; a table with the field next
//   all(...)       its arguments: a call whose result is returned is no tail call
//   none()         no value: `...` of the script itself
//   tostring(v)    text of any value; __tostring where there is one
//   next(t, k)     the next key and value of a table
//   zero           the number 0; -zero is a negative zero, for which 5.1 has no constant
//
// `tostring` and `next` are looked up at each use: a runtime may put its own there. Errors have
// Luau's words and the position of the script that calls. No helper yields, nor may the
// metamethods that it calls.
#pragma once

struct lua_State;

namespace obby::luau {

// Pushes a new table of helpers.
void pushHelpers(lua_State* state);

}  // namespace obby::luau
