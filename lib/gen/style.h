// A level style: how to build one obstacle, and which of its parameters a recipe may set.
#pragma once

#include <span>

namespace obby::gen {

class Sketch;

// A value of a style that depends on the difficulty.
struct Parameter {
  const char* name;         // name in recipes, within its style
  const char* unit;         // "studs"; "" for a count or a share
  float easy, hard;         // values at difficulty 0 and 1, unless the recipe sets others
  float min, max;           // range allowed in recipes
  const char* description;  // text in listings
};

// Appends one obstacle ahead of the sketch's edge and moves the edge behind it. The result depends
// only on the sketch.
using BuildObstacle = void (*)(Sketch&);

struct Style {
  const char* name;
  const char* description;
  BuildObstacle build;
  std::span<const Parameter> parameters = {};
  bool chains = false;  // consists of obstacles of other styles; `build` is null
  bool single = false;  // at most one in a level, since dynamic parts are few and detours long
  bool wide = false;    // extends to the sides; the route does not turn next to it, which would
                        // open shortcuts
};

}  // namespace obby::gen
