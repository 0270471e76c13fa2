// An image as a PNG file in memory.
#pragma once

#include <string>

#include "base/result.h"
#include "view/picture/canvas.h"

namespace obby::view {

// 8 bits a channel, no alpha. Equal images have equal bytes. Error: out of memory.
Result<std::string> pngOf(const Image& image);

}  // namespace obby::view
