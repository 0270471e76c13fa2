// Kills players whom the part squeezes against another part.
#include "level/behaviours/behaviour.h"

namespace obby::level {

Status compileSqueeze(PartContext& c) {
  if (c.part.getSolid()) c.flags |= kCrush;
  return {};
}

}  // namespace obby::level
