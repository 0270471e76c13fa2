#include "engine/move_run.h"

#include <utility>

#include "engine/probe_run.h"

namespace obby::engine {
namespace {

constexpr double kWalk = 1, kState = 0.5, kAfter = 1, kMaxFlight = 4;  // seconds
constexpr float kHigh = 60;                                            // studs
constexpr const char* kStates[] = {"Climbing", "Swimming",  "Seated",           "FallingDown",
                                   "Ragdoll",  "GettingUp", "PlatformStanding", "Running"};

void land(Stage& stage) {
  for (uint32_t frame = 0; frame < framesOf(kMaxFlight) && stage.fly(); ++frame) stage.run(1);
}

void move(Stage& stage, Approach approach) {
  if (approach == Approach::walk) {
    stage.walk(true);
    stage.run(framesOf(kWalk));
    stage.walk(false);
  } else if (approach == Approach::jump) {
    stage.jump();
    stage.run(1);
    land(stage);
  } else if (approach == Approach::fall) {
    stage.drop(kHigh);
    land(stage);
  } else {
    for (const char* state : kStates) {
      stage.enter(state);
      stage.run(framesOf(kState));
    }
  }
  stage.run(framesOf(kAfter));
}

}  // namespace

Move runMove(Stage& stage, Approach approach, bool again) {
  if (again) move(stage, approach);
  stage.restart();
  Probe probe;
  probe.approach = approach;
  probe.at = stage.frames() * kFrame;
  move(stage, approach);
  probe.left = stage.frames() * kFrame;
  probe.seen = stage.observation();
  return {std::move(probe), stage.probes()};
}

}  // namespace obby::engine
