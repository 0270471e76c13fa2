// The palette of the numbered colours that old files use.
#pragma once

#include <cstdint>

#include "import/document.h"

namespace obby::importer {

// Medium stone grey (194), as in the engine, for numbers that the palette does not have.
ColorRgb brickColor(int64_t number);

}  // namespace obby::importer
