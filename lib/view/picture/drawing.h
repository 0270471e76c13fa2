// A line drawing of a query in SVG, from above or from the side, with its trajectories.
#pragma once

#include <string>

#include "view/report.h"

namespace obby::view {

enum class Side { above, lateral };

struct DrawingOptions {
  Side side = Side::above;
  int width = 960;  // pixels; the height follows from the level
};

// The longer side runs across, with the start on the left. `query` may be null for the whole level.
// Parts that are away at the query's start are faint, with dashed edges. The drawing suits light
// and dark pages.
std::string drawingOf(const LevelEntry& level, const QueryEntry* query,
                      const DrawingOptions& options);

}  // namespace obby::view
