// The palette of the numbered colours that old files use.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/document.h"

namespace obby {

// Medium stone grey (194), as in the engine, for numbers that the palette does not have.
ColorRgb brickColor(int64_t number);

// The number of a colour; nothing: the palette has no such one.
std::optional<int64_t> brickColorNumber(ColorRgb color);
int64_t nearestBrickColorNumber(ColorRgb color);
// The number at a place of the palette, counted round.
int64_t paletteColor(size_t index);

// Names that makers use; other numbers are called "Color N".
std::string brickColorName(int64_t number);
std::optional<int64_t> brickColorNamed(std::string_view name);

}  // namespace obby
