// A query's course as a line drawing in SVG, from above or from the side, with its paths.
#pragma once

#include <string>

#include "view/report.h"

namespace obby::view {

enum class Side { above, beside };

struct DrawingOptions {
  Side side = Side::above;
  int width = 960;  // pixels; the height follows from the course
};

// The course's longer side runs across, its start to the left. `query` may be null: the whole
// level. What is away when the query starts is faint, its edge dashed. Reads on light and on dark
// pages.
std::string drawingOf(const LevelEntry& level, const QueryEntry* query,
                      const DrawingOptions& options);

}  // namespace obby::view
