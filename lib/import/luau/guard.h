// Events of a handler that a condition guards.
#pragma once

#include <cstddef>
#include <limits>

#include "engine/luau/ast.h"
#include "import/luau/datum.h"

namespace obby::importer::luau {

using namespace obby::luau;

// The end of events that nothing closes: all that follow are among them.
constexpr size_t kOpenEnd = std::numeric_limits<size_t>::max();

// Events that come only if a condition holds, or only if it does not.
struct Guard {
  const Expr* condition = nullptr;
  Scope* scope = nullptr;  // where it is asked
  int line = 0;
  bool holds = true;
  size_t first = 0, end = kOpenEnd;  // indices of events of the timeline
};

}  // namespace obby::importer::luau
