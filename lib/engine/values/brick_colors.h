// The palette of the numbered colours that old files use.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/document.h"

namespace obby {

// Returns a palette colour. For other numbers, returns medium stone grey (194), as the engine does.
ColorRgb brickColor(int64_t number);

// Returns the number of a colour, or nullopt if the palette does not have it.
std::optional<int64_t> brickColorNumber(ColorRgb color);
int64_t nearestBrickColorNumber(ColorRgb color);
// Returns the number at an index of the palette, which wraps around.
int64_t paletteColor(size_t index);

// Returns the colour's name. Numbers without one are called "Color N".
std::string brickColorName(int64_t number);
std::optional<int64_t> brickColorNamed(std::string_view name);

}  // namespace obby
