// A player's view in methods that learn during the search. Host only.
#pragma once

#include "geom/region.h"
#include "solve/learned/episode.h"

namespace obby::solve::learned {

struct View {
  const Episode* player;
  geom::Region next;  // region that the player has to reach
  Turns ahead;        // heading of the observation
};

}  // namespace obby::solve::learned
