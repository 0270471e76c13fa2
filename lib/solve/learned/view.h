// What a player of a method that learns while it searches looks at. Host only.
#pragma once

#include "geom/region.h"
#include "solve/learned/episode.h"

namespace obby::solve::learned {

struct View {
  const Episode* player;
  geom::Region next;  // what the player is to reach
  Turns ahead;        // where the frame looks
};

}  // namespace obby::solve::learned
