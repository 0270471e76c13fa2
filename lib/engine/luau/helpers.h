// The functions that emitted Lua (emit.h) calls. The table's fields, all functions unless said
// otherwise:
//
//   len(v)         #v: the bytes of a string; the result of __len; the border of a table
//   idiv(a, b)     a // b: floor(a / b) of numbers and numeric strings; else __idiv
//   cat(a, ...)    a .. b ..., from the right, by __concat if an operand is neither string nor
//                  number; numbers as numberText() writes them
//   catn(n, list)  the same for list[1] .. list[n]
//   interp(...)    an interpolated string from its parts: strings unchanged, numbers by
//                  numberText(), others by the field tostring
//   iter(a, b, c)  the iterator of `for ... in a, b, c`: a function itself; else the result of
//                  a's __iter; else a itself if it has __call; else the field next for a table
//   all(...)       its arguments: a call whose result is returned is no tail call
//   none()         no value: `...` of the script itself
//   tostring(v)    text of any value; calls __tostring if there is one
//   next(t, k)     the next key and value of a table
//   zero           the number 0; -zero is a negative zero, for which 5.1 has no constant
//
// `tostring` and `next` are looked up at each use: a runtime may replace them. Errors have Luau's
// words and the position of the calling script. Neither helpers nor the metamethods that they call
// may yield.
#pragma once

struct lua_State;

namespace obby::luau {

// Pushes a new table of helpers.
void pushHelpers(lua_State* state);

}  // namespace obby::luau
