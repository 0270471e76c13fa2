// The palette of the numbered colours that old files use.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/document.h"

namespace obby::importer {

// Medium stone grey (194), as in the engine, for numbers that the palette does not have.
ColorRgb brickColor(int64_t number);

// The number of a colour; nothing: the palette has no such one.
std::optional<int64_t> brickColorNumber(ColorRgb color);

}  // namespace obby::importer
