// An image as a PNG file in memory.
#pragma once

#include <string>

#include "base/result.h"
#include "view/picture/canvas.h"

namespace obby::view {

// 8 bits a channel, no alpha. The same image gives the same bytes. Error: too little memory.
Result<std::string> pngOf(const Image& image);

}  // namespace obby::view
