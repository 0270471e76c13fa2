// Luau to Lua 5.1: the text of a parsed script for a VM that knows neither types nor `continue`,
// compound assignment, if-expressions, interpolated strings, `//` and iteration over tables.
//
// Every statement stands on its line of the script, so that the VM's errors and debug information
// name the script's lines. The answer depends on the script's text only.
//
// The chunk takes one argument, the table of helpers (helpers.h), which it keeps in a local
// variable; `...` of the script itself is empty. Emitted names begin with a prefix, such as L_,
// that no variable of the script has.
//
// What differs from Luau:
// - Variables of a scope move into a table where a function would have too many upvalues or local
//   variables for 5.1. The VM's messages then name a field instead of a local variable.
// - Iterators of `for` and metamethods may not yield: 5.1 calls them from C.
// - A table constructor sets positional items last: {"a", [1] = "b"}[1] is "a".
// - `==` of a value with itself never calls __eq.
// - 5.1 allows 200 levels of nested blocks and brackets, 250 registers in a function, and 200
//   parameters: a script beyond that is refused when the VM loads it.
#pragma once

#include <string>

#include "base/result.h"
#include "engine/luau/ast.h"

namespace obby::luau {

// The error of a broken chunk, or of an assignment to a constant, has the line as its place.
Result<std::string> emit(const Chunk& chunk);

// parse() and emit().
Result<std::string> toLua(std::string_view source);

}  // namespace obby::luau
