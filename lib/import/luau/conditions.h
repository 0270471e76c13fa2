// What the condition of a loop or branch asks for.
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "engine/luau/ast.h"

namespace obby::importer::luau {

using namespace obby::luau;

// "part.Transparency"; empty where it is anything but names.
std::string pathOf(const Expr& expr);

// The paths in a condition. `looked` grows by the number of expressions that were looked at.
std::set<std::string> pathsIn(const Expr& condition, size_t& looked);

// Of the paths that lead to a pose or a piece of it, all by which that may be set.
std::set<std::string> posesAmong(const std::set<std::string>& paths);

// The name of which a branch under the condition sets the default, as it is of
// `if not speed then speed = 10 end`. Empty: of none.
std::string defaulted(const Expr& condition);

// Whether it is a call, as `while wait(1) do` has it.
bool isWait(const Expr& expr);

// Whether nothing in the running game turns it: literals, and waits, which always hold.
bool isFixed(const Expr& expr);

// Whether one of the paths is a clock.
bool asksClock(const std::set<std::string>& paths);

// Whether it asks how far a tween is.
bool asksTween(const Expr& expr);

}  // namespace obby::importer::luau
