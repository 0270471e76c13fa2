// An image as a PNG file in memory.
#pragma once

#include <string>

#include "base/result.h"
#include "view/picture/canvas.h"

namespace obby::view {

// Returns the image as PNG with 8 bits per channel and no alpha. Equal images have equal bytes.
// Error: out of memory.
Result<std::string> pngOf(const Image& image);

}  // namespace obby::view
