// A query and its trajectories in the level, as a picture that needs no display.
#pragma once

#include <cstddef>

#include "view/picture/canvas.h"
#include "view/report.h"

namespace obby::view {

struct PictureOptions {
  int width = 1280, height = 720;  // pixels
  // Samples that are held at a time, 4 a pixel, at 36 to 56 bytes each; a row of pixels at least.
  // The picture is the same whatever it is.
  size_t atOnce = size_t(1) << 22;
};

// From a place beside the course from which all of it is seen, the start to the left. Moving parts
// are where they are when the query starts, and what is away then is hardly there. `query` may be
// null: the whole level then.
Image pictureOf(const LevelEntry& level, const QueryEntry* query, const PictureOptions& options);

}  // namespace obby::view
