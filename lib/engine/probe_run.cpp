#include "engine/probe_run.h"

#include <algorithm>
#include <cmath>

namespace obby::engine {
namespace {

constexpr double kHold = 1.1;        // seconds that a probe stays: longer than most polls wait
constexpr double kPatientHold = 4;   // seconds
constexpr uint32_t kTouchEvery = 5;  // frames between the touches of a patient probe
constexpr double kSecondHit = 5;     // seconds that it waits to be harmed again
constexpr double kQuiet = 1.0;       // seconds without a change end a probe
constexpr double kAtLeast = 1.5;

// Whether a second hit is still to come after the first.
bool awaitsHit(Stage& stage, double now) {
  double first = -1, last = -1;
  for (const Harm& harm : stage.harms())
    if (harm.hurts()) {
      if (first < 0) first = harm.time;
      last = harm.time;
    }
  return first >= 0 && last == first && now < first + kSecondHit;
}

}  // namespace

uint32_t framesOf(double seconds) { return uint32_t(std::lround(seconds / kFrame)); }

Probe runProbe(Stage& stage, const Plan& plan, Probe probe, Manner manner) {
  stage.restart();
  const uint32_t most = framesOf(plan.probeSeconds);
  const bool stands = probe.approach != Approach::use;
  uint32_t hold = framesOf(manner.patient ? kPatientHold : kHold), frame = 0, quiet = 0;
  const uint32_t least = manner.patient ? hold : framesOf(kAtLeast);
  if (!stands) stage.use(probe.target);
  while (frame < most && (frame < least || quiet < framesOf(kQuiet))) {
    const bool awaits = stands && frame <= hold && awaitsHit(stage, probe.at + frame * kFrame);
    const bool insists = stands && manner.patient && frame < hold && frame % kTouchEvery == 0 &&
                         stage.harms().empty();
    if (awaits) hold = std::max(hold, frame + 1);
    if (stands && frame < hold)
      stage.standAt(probe.target, probe.approach == Approach::inside, manner.share, manner.face);
    else if (stands && frame == hold)
      stage.leave();
    // A part next to the spawn may have been touched all the time.
    const bool arrives = stands && frame == 0;
    if (arrives || awaits || insists) stage.touchAgain();
    const size_t before = stage.activity();
    stage.run(1);
    ++frame;
    quiet = stage.activity() == before && !stage.isBusy() && !awaits ? quiet + 1 : 0;
    if (!stage.playerLives()) break;
  }
  probe.left = probe.at + hold * kFrame;
  probe.seen = stage.observation();
  return probe;
}

}  // namespace obby::engine
