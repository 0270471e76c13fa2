// Starts a signal when the part is touched.
#include "level/behaviours/behaviour.h"

namespace obby::level {

Status compileButton(PartContext& c) {
  start(c, c.clocks.button(c.part.getButton().getSignal()));
  return {};
}

}  // namespace obby::level
