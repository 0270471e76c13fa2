// Parses Luau text. It is tolerant: text that is no statement is skipped and marks the chunk
// broken, so that the rest still counts. The first error is kept with its line. Nesting is bounded.
#pragma once

#include <string_view>

#include "engine/luau/ast.h"

namespace obby::luau {

Chunk parse(std::string_view source);

}  // namespace obby::luau
