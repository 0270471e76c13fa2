// The effects of a place's scripts: those without a player's action, and those of a player's touch
// or use of each part.
#pragma once

#include <string>
#include <vector>

#include "engine/observation.h"
#include "engine/settings.h"

namespace obby::engine {

enum class Approach : uint8_t {
  stand,
  inside,
  use,
  keys,  // all keys and mouse buttons are pressed and released
  chat,  // the player says texts that scripts may wait for
  // The player moves without touching a part (Report::moves).
  walk,
  jump,
  fall,
  exert,  // climbs, swims, sits and the like
  away    // stands in the air, far from all parts
};
constexpr bool isTouch(Approach approach) { return approach <= Approach::inside; }

// The harm that a part does in another copy of the place.
struct SecondLook {
  std::vector<Harm> harms;
  double left = 0;  // when the player went away; 0: it stayed to the end
};

// A visit of the player to a part, in a copy of the running place.
struct Probe {
  InstanceId target = kNoInstance;  // the part, ClickDetector, prompt or tool
  Approach approach = Approach::stand;
  double at = 0;         // when the player arrived
  double left = 0;       // when it went away; 0: stayed to the end
  Observation seen;      // events since the arrival
  SecondLook brief;      // second probe of a part that harms repeatedly: the player leaves at once
  SecondLook still;      // second probe of a part that harms once: the player only stays
  bool lost = false;     // the copy died or ran out of time
  bool byPlace = false;  // no script listens to the part: the player's position decides
  bool allOver = true;   // the effect also occurs near two opposite corners
  bool byRoot = false;   // no effect if only limbs are in the part
  bool byFall = false;   // a player that falls from high above gets another effect
  uint64_t listenerHash = 0;  // hash of the functions that listen to the part; 0: none
  bool sleeps = false;        // something that the touch began still waits at the end
  // The player died of the touch, or after a touch without effects, and lives again.
  bool reborn = false;
  Vec3 rebornAt;  // feet of the new body
};

// A part that was not probed because there are too many. The same functions listen to a probed
// part.
struct SameListeners {
  InstanceId target = kNoInstance;
  uint32_t probe = 0;  // index into Report::probes
};

// The reason why a part acts differently from its first probe.
enum class Cause : uint8_t {
  again,   // it has been touched before
  time,    // time has passed, or the player has stayed
  lever,   // another part has been touched
  several  // several others have been touched, or the lever is unknown
};

// A probe after touches of other parts that differs from the part's first one.
struct Revisit {
  Probe probe;
  Cause cause = Cause::several;
  InstanceId lever = kNoInstance;  // the target whose touch causes the change
};

// Jumps in the air that scripts grant the player between two floors.
struct AirJumps {
  uint16_t count = 0;
  Line line;
};
constexpr uint16_t kNoLimit = 0xffff;

struct Report {
  Observation undisturbed;
  std::vector<Probe> probes;
  std::vector<SameListeners> sameListeners;
  std::vector<Revisit> revisits;
  std::vector<Probe> moves;                  // moves away from all parts, if scripts watch them
  double probedAt = 0;                       // seconds; start of the first probes
  double lookedAgainAt = 0;                  // seconds; start of the second round; 0: none
  std::vector<MadePart> made;                // parts made by probedAt, then later ones
  std::vector<std::string> collisionGroups;  // groups that exist at probedAt
  PlayerState arrived;                       // the player's state at probedAt
  AirJumps airJumps;
  bool complete = false;             // the undisturbed run reached its end
  bool over = false;                 // the run is complete and nothing more can happen
  bool sleeps = false;               // some threads still wait for the first time
  std::string failure;               // why the report is incomplete, for people
  InstanceId culprit = kNoInstance;  // script that ran as the child died or used up memory
};

struct Plan {
  Settings settings;
  double seconds = 60;       // duration of the undisturbed run
  double probeAt = 3;        // start of the probes, seconds
  double probeSeconds = 12;  // duration of the longest probe
  size_t maxProbes = 600;
  double timeLimit = 60;  // seconds of wall time for the whole run, far above the budgets
  size_t processes = 2;   // copies at a time
};

// Calls `visit` with each observation of a report, which may be const.
template <class AnyReport, class Visit>
void eachObservation(AnyReport& report, const Visit& visit) {
  visit(report.undisturbed);
  for (auto& probe : report.probes) visit(probe.seen);
  for (auto& move : report.moves) visit(move.seen);
  for (auto& revisit : report.revisits) visit(revisit.probe.seen);
}

}  // namespace obby::engine
