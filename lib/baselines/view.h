// A player's view in methods that learn during the search. Host only.
#pragma once

#include "baselines/episode.h"
#include "baselines/names.h"
#include "geom/region.h"

namespace obby::baselines {

struct View {
  const Episode* player;
  geom::Region next;  // region that the player has to reach
  Turns ahead;        // heading of the observation
};

}  // namespace obby::baselines
