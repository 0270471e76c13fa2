// Luau text to its parsed form. Tolerant: what is no statement is skipped and marks the chunk
// broken, so that the rest still counts; the first error is told with its line. Nesting is bounded.
#pragma once

#include <string_view>

#include "engine/luau/ast.h"

namespace obby::luau {

Chunk parse(std::string_view source);

}  // namespace obby::luau
