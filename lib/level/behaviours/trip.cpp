// Takes control from a player who touches the part, for a time.
#include "level/behaviours/behaviour.h"

namespace obby::level {

Status compileTrip(PartContext& c) {
  const auto record = c.part.getTrip();
  Clock clock;
  OBBY_ASSIGN(clock.helpless, ticksOf(c.params, record.getSeconds(), "trip.seconds"));
  OBBY_ASSIGN(const uint32_t after, ticksOf(c.params, record.getAfter(), "trip.after"));
  clock.length = clock.helpless + after;
  if (clock.helpless != 0) start(c, c.clocks.share(clock));
  return {};
}

}  // namespace obby::level
