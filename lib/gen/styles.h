// The table of level styles: one row each. A new style is a file in styles/ and a row in
// styles.cpp.
#pragma once

#include <string_view>
#include <vector>

#include "gen/sketch.h"

namespace obby::gen {

// Appends one obstacle ahead of the sketch's edge, and leaves the edge behind it. What it draws
// depends on the sketch alone.
using BuildObstacle = void (*)(Sketch&);

struct Style {
  const char* name;
  const char* description;
  BuildObstacle build;
  bool chains = false;  // made of obstacles of other styles; `build` is null
  bool single = false;  // at most one such obstacle a level: loose parts are few, detours long
  bool wide = false;    // spreads to the sides: no turn beside it, which would open short cuts
};

const std::vector<Style>& styles();
// Null if there is none of that name.
const Style* findStyle(std::string_view name);

}  // namespace obby::gen
