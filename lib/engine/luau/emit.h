// Translates Luau to Lua 5.1, for a VM without types, `continue`, compound assignment,
// if-expressions, interpolated strings, `//` and iteration over tables.
//
// Every statement stands on its line of the script, so that the VM's errors and debug information
// name the script's lines. The value of an assignment moves up to the statement's line unless it
// calls a function or contains one. The output depends on the script's text only.
//
// The chunk takes one argument, the table of helpers (helpers.h), and keeps it in a local variable.
// `...` of the script itself is empty. Emitted names begin with a prefix, such as L_, that no
// variable of the script has.
//
// Differences from Luau:
// - Variables of a scope move into a table where a function would have too many upvalues or local
//   variables for 5.1. The VM's messages then name a field instead of a local variable.
// - Iterators of `for` and metamethods may not yield: 5.1 calls them from C.
// - A table constructor sets positional items last: {"a", [1] = "b"}[1] is "a".
// - In an expression over several lines, an operator's error names the line of its last operand.
// - 0 * -1 of constants is 0 if the function has the constant 0.
// - `==` of a value with itself never calls __eq.
// - 5.1 allows 200 levels of nested blocks and brackets, 250 registers in a function, and 200
//   parameters. The VM rejects larger scripts when it loads them.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "engine/luau/ast.h"

namespace obby::luau {

// Emits a parsed chunk. Fails for a broken chunk, an assignment to a constant, or a `continue` that
// skips a variable of its loop's condition. The error's place is the line.
Result<std::string> emit(const Chunk& chunk);

// Calls parse() and emit().
Result<std::string> toLua(std::string_view source);

}  // namespace obby::luau
