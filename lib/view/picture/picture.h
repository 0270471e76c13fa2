// Renders a query and its trajectories in the level without a display.
#pragma once

#include <cstddef>

#include "view/picture/canvas.h"
#include "view/report.h"

namespace obby::view {

struct PictureOptions {
  int width = 1280, height = 720;  // pixels
  bool attempts = false;           // draw failed attempts, too
  // Max samples in memory, 4 per pixel and 36 to 56 bytes each, but at least those of a row of
  // pixels. The value does not change the picture.
  size_t atOnce = size_t(1) << 22;
};

// The camera is next to the level and sees all of it, with the start on the left. Moving parts have
// their poses at the query's start, and parts that are away then are almost transparent. `query`
// may be null for the whole level.
Image pictureOf(const LevelEntry& level, const QueryEntry* query, const PictureOptions& options);

}  // namespace obby::view
