#include "engine/move_run.h"

#include <algorithm>
#include <utility>

#include "engine/probe_run.h"
#include "engine/report_bytes.h"

namespace obby::engine {

template <class A>
void fields(A& a, Move& m) {
  a(m.probe), a(m.targets);
}

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
  } else if (approach == Approach::away) {
    for (uint32_t frame = 0; frame < framesOf(kWalk); ++frame) {
      stage.standAway();
      stage.run(1);
    }
  } else {
    for (const char* state : kStates) {
      stage.enter(state);
      stage.run(framesOf(kState));
    }
  }
  stage.run(framesOf(kAfter));
}

// Runs the move in this copy of the place. With `again`, makes the move once before that.
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

}  // namespace

void Moves::run(std::vector<Probe>& moves) {
  std::vector<Approach> list;
  if (stage_.heedsMoves())
    list = {Approach::walk, Approach::jump, Approach::jump, Approach::fall, Approach::exert};
  if (stage_.looksAtPlayer()) list.push_back(Approach::away);
  moves.resize(list.size());
  for (size_t i = 0; i < list.size(); ++i) {
    const bool again = i > 0 && list[i] == list[i - 1];
    moves[i].approach = list[i];
    children_.start(
        plan_.timeLimit * kCopyShare,
        [&, i, again] { return toBytes(runMove(stage_, list[i], again)); },
        [&, i](const std::string& bytes) {
          Move move;
          moves[i].lost = !fromBytes(bytes, move);
          if (!moves[i].lost) moves[i] = std::move(move.probe);
          found_.insert(found_.end(), move.targets.begin(), move.targets.end());
        });
  }
  children_.finish();
}

void Moves::addTargets(std::vector<Probe>& wanted) const {
  for (const Probe& found : found_)
    if (isTouch(found.approach) && found.target < kMade &&
        std::none_of(wanted.begin(), wanted.end(),
                     [&](const Probe& known) { return known.target == found.target; }))
      wanted.push_back(found);
}

}  // namespace obby::engine
