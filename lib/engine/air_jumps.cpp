#include "engine/air_jumps.h"

#include <algorithm>

#include "engine/probe_run.h"

namespace obby::engine {
namespace {

// Seconds from the take-off to the first press, and between presses. Both exceed the delays that
// scripts set between jumps.
constexpr double kUntilPress = 0.5, kPause = 0.5;
constexpr uint16_t kPresses = 5;  // more jumps than any game counts

// Returns the change by which a script made the player jump, or null if there is none.
const Change* jumpIn(const Observation& seen) {
  const auto made =
      std::find_if(seen.changes.begin(), seen.changes.end(), [](const Change& change) {
        const auto* const state = std::get_if<std::string>(&change.value);
        return change.property == "note state" && state && *state == "Jumping";
      });
  return made == seen.changes.end() ? nullptr : &*made;
}

AirJumps fly(Stage& stage) {
  AirJumps found;
  stage.takeOff();
  stage.run(framesOf(kUntilPress));
  for (uint16_t press = 0; press < kPresses; ++press) {
    stage.restart();
    stage.pressJump();
    stage.run(1);
    stage.fall();
    stage.run(framesOf(kPause));
    const Change* const jump = jumpIn(stage.observation());
    if (!jump) break;
    if (found.count++ == 0) found.line = jump->line;
  }
  stage.land();
  stage.run(framesOf(kPause));
  return found;
}

}  // namespace

AirJumps findAirJumps(Stage& stage) {
  const AirJumps first = fly(stage), again = fly(stage);
  AirJumps found = first.count < again.count ? first : again;
  if (found.count == kPresses) found.count = kNoLimit;
  return found;
}

}  // namespace obby::engine
