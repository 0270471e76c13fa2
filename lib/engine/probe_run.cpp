#include "engine/probe_run.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace obby::engine {
namespace {

constexpr double kHold = 1.1;  // seconds that a probe stays; longer than most polling intervals
constexpr double kPatientHold = 4;   // seconds
constexpr uint32_t kTouchEvery = 5;  // frames between the touches of a patient probe
constexpr double kSecondHit = 5;     // seconds to wait for a second hit
constexpr double kPress = 2;         // seconds that keys and buttons are held
constexpr float kFallSpeed = 140;    // studs/s, reached after about 50 studs
constexpr uint32_t kFastFrames = 3;  // frames in which a falling player still has its speed
constexpr double kQuiet = 1.0;       // seconds without a change end a probe
constexpr double kMinProbe = 1.5;
// Seconds from death to respawn: bounds on the place's RespawnTime, and extra time for scripts that
// load the body themselves.
constexpr double kMinRespawn = 5, kLongestRespawn = 30, kScriptedWait = 6;
constexpr uint32_t kBetweenLooks = 10;  // frames between two checks for the next body
constexpr double kPlacing = 1;          // seconds that scripts take to place a new body

// Returns the times at which the player was hurt first and last, or nullopt if it was not hurt.
std::optional<std::pair<double, double>> hurtIn(const std::vector<Harm>& harms) {
  std::optional<std::pair<double, double>> span;
  for (const Harm& harm : harms)
    if (harm.hurts()) span = {span ? span->first : harm.time, harm.time};
  return span;
}

// Returns true if a second hit may still follow the first.
bool awaitsHit(Stage& stage, double now) {
  const auto span = hurtIn(stage.harms());
  return span && span->first == span->second && now < span->first + kSecondHit;
}

// Returns true if the only effects are numbers that scripts store.
bool isQuiet(const Observation& seen) {
  return seen.harms.empty() && seen.tracks.empty() &&
         std::all_of(seen.changes.begin(), seen.changes.end(), [](const Change& change) {
           return change.property.rfind("note stat ", 0) == 0;
         });
}

// Returns true if scripts set the player's progress, or a number that they store for it.
bool isProgress(const Observation& seen) {
  constexpr std::string_view kNotes[] = {"note respawn", "note team", "note stat "};
  return std::any_of(seen.changes.begin(), seen.changes.end(), [&](const Change& change) {
    return std::any_of(std::begin(kNotes), std::end(kNotes),
                       [&](std::string_view note) { return change.property.rfind(note, 0) == 0; });
  });
}

double longestDeath(Stage& stage) {
  const double respawn = std::fmin(std::fmax(stage.respawnTime(), kMinRespawn), kLongestRespawn);
  return respawn + kScriptedWait;
}

// Finds where the next body appears. Scripts may store a checkpoint out of sight, and a portal may
// kill the player to move it.
void comeBack(Stage& stage, Probe& probe) {
  const uint32_t end = stage.frames() + framesOf(longestDeath(stage));
  if (stage.playerLives()) stage.die();
  stage.run(1);
  while (!stage.playerLives() && !stage.isExhausted() && stage.frames() < end)
    stage.run(kBetweenLooks);
  probe.reborn = stage.playerLives();
  stage.run(framesOf(kPlacing));
  probe.rebornAt = stage.observation().player.feet;
}

}  // namespace

uint32_t framesOf(double seconds) { return uint32_t(std::lround(seconds / kFrame)); }

Probe runProbe(Stage& stage, const Plan& plan, Probe probe, Manner manner) {
  stage.restart();
  const uint32_t max = framesOf(plan.probeSeconds);
  const bool stands = isTouch(probe.approach);
  uint32_t hold = framesOf(manner.patient ? kPatientHold : kHold), frame = 0, quiet = 0;
  const bool lasts = !stands && stage.use(probe.target);
  const uint32_t min = manner.patient ? hold : framesOf(lasts ? kPress + kQuiet : kMinProbe);
  while (frame < max && (frame < min || quiet < framesOf(kQuiet))) {
    const bool leaves = manner.stay == Stay::brief && hurtIn(stage.harms());
    if (leaves) hold = std::min(hold, frame);
    const bool awaits =
        !leaves && stands && frame <= hold && awaitsHit(stage, probe.at + frame * kFrame);
    const bool insists = stands && manner.patient && frame < hold && frame % kTouchEvery == 0 &&
                         stage.harms().empty();
    if (awaits) hold = std::max(hold, frame + 1);
    if (stands && frame < hold)
      stage.standAt(probe.target, probe.approach == Approach::inside, manner.share, manner.face,
                    manner.falls && frame < kFastFrames ? kFallSpeed : 0);
    else if (stands && frame == hold)
      stage.leave();
    if (lasts && frame == framesOf(kPress)) stage.release(probe.target);
    // The player may have been touching a part next to the spawn from the start.
    const bool arrives = stands && frame == 0;
    const bool renews = awaits && manner.stay == Stay::renewing;
    if (arrives || renews || insists) stage.touchAgain();
    const size_t before = stage.activity();
    stage.run(1);
    ++frame;
    quiet = stage.activity() == before && !stage.isBusy() && !awaits ? quiet + 1 : 0;
    if (!stage.playerLives()) break;
  }
  probe.sleeps = frame >= max && stage.sleeps();
  probe.left = probe.at + hold * kFrame;
  probe.seen = stage.observation();
  const bool isPortal = !stage.playerLives() && isProgress(probe.seen);
  const bool mayBeKept = stage.playerLives() && isQuiet(probe.seen) && stage.hearsNewBodies();
  if (manner.comesBack && stands && !probe.byPlace && (isPortal || mayBeKept))
    comeBack(stage, probe);
  return probe;
}

std::optional<Stay> secondLookAt(const Probe& probe) {
  const auto span = hurtIn(probe.seen.harms);
  if (!span || probe.lost || !isTouch(probe.approach)) return std::nullopt;
  if (span->first < span->second) return Stay::brief;
  return probe.seen.player.alive ? std::optional(Stay::still) : std::nullopt;
}

SecondLook lookAgain(Stage& stage, const Plan& plan, const Probe& wanted, Stay stay) {
  const Probe probe = runProbe(stage, plan, wanted, {.stay = stay});
  return {probe.seen.harms, probe.left};
}

SecondLook& secondLookOf(Probe& probe, Stay stay) {
  return stay == Stay::brief ? probe.brief : probe.still;
}

}  // namespace obby::engine
