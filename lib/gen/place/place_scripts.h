// Luau scripts that implement a part's roles in Studio. Private to lib/gen.
#pragma once

#include <string>
#include <vector>

#include "gen/part_sketch.h"

namespace obby::gen {

struct PlaceScript {
  const char* name;
  std::string source;
};

// Returns the scripts of one part. Its level is moved by `shift` in the place. `parts`: all parts
// of the level; a button controls those with its signal.
std::vector<PlaceScript> scriptsOf(const PartSketch& part, const std::vector<PartSketch>& parts,
                                   Vec3 shift);

// Returns the script of the place that respawns players at the last checkpoint they touched.
PlaceScript checkpointScript();

}  // namespace obby::gen
