// Lua 5.1, built as C++: its errors are exceptions, so destructors run.
// Private to lib/engine.
#pragma once

#include <lua5.1/lua.hpp>
