// A vector drawing of a query in SVG, with its trajectories.
#pragma once

#include <string>

#include "view/report.h"

namespace obby::view {

// `best` is the side of a picture, which hides least of the query.
enum class Side { best, above, lateral };

struct DrawingOptions {
  Side side = Side::best;
  bool attempts = false;  // draw failed attempts, too
  int width = 960;        // pixels; the height follows from the level
};

// From above and from the side, the longer side runs across, with the start on the left. `query`
// may be null for the whole level. Parts that are away at the query's start are faint, with dashed
// edges. The drawing suits light and dark pages.
std::string drawingOf(const LevelEntry& level, const QueryEntry* query,
                      const DrawingOptions& options);

}  // namespace obby::view
