// What a style of levels is: how one obstacle of it is built, and what of that a recipe may set.
#pragma once

#include <span>

namespace obby::gen {

class Sketch;

// Something that a style draws by the difficulty.
struct Parameter {
  const char* name;         // in recipes, of its style
  const char* unit;         // "studs"; "": a number of things, or a share
  float easy, hard;         // at difficulty 0 and 1, unless the recipe gives others
  float least, most;        // that a recipe may give for either
  const char* description;  // for those who read lists
};

// Appends one obstacle ahead of the sketch's edge, and leaves the edge behind it. What it draws
// depends on the sketch alone.
using BuildObstacle = void (*)(Sketch&);

struct Style {
  const char* name;
  const char* description;
  BuildObstacle build;
  std::span<const Parameter> parameters = {};
  bool chains = false;  // made of obstacles of other styles; `build` is null
  bool single = false;  // at most one such obstacle a level: loose parts are few, detours long
  bool wide = false;    // spreads to the sides: no turn beside it, which would open short cuts
};

}  // namespace obby::gen
