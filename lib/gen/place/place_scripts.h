// Luau scripts that make a part do in Studio what its roles say. Private to lib/gen.
#pragma once

#include <string>
#include <vector>

#include "gen/part_sketch.h"

namespace obby::gen {

struct PlaceScript {
  const char* name;
  std::string source;
};

// Scripts for one part, whose level stands `shift` away from where it was made. `parts`: all of its
// level, of which a button works those that name its signal.
std::vector<PlaceScript> scriptsOf(const PartSketch& part, const std::vector<PartSketch>& parts,
                                   Vec3 shift);

// For the whole place: players come back at the last checkpoint that they touched.
PlaceScript checkpointScript();

}  // namespace obby::gen
