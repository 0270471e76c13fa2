// Who is in a low part when a jump has begun is put out of it: until then the torso does not
// collide, and the head passes over it. Where something taller stands behind, that has them next,
// and puts them out on its far side where it is thin: so on, at once, through all that are thin and
// flush behind.
#pragma once

#include "solve/proof/pressing.h"
#include "solve/proof/solids.h"

namespace obby::solve {

// Can there be anything of the kind? A first look, which takes no index.
bool mayPassThrough(const level::LevelView& level, bool mayJump);

// Notes what takes somebody along so, and where.
void passThrough(const level::LevelView& level, const Solids& solids, bool mayJump,
                 Pressing& found);

}  // namespace obby::solve
