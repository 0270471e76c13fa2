// What a place's scripts do: by themselves, and to each part that a player touches or uses.
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
  keys,  // all keys and mouse buttons are held and let go
  chat,  // the player says what scripts may wait for
  // The player moves without touching a part (Report::moves).
  walk,
  jump,
  fall,
  exert,  // climbs, swims, sits and the like
  away    // stands in the air far from all that is around the spawn
};
constexpr bool isTouch(Approach approach) { return approach <= Approach::inside; }

// The harm that a part does in another copy of the place.
struct SecondLook {
  std::vector<Harm> harms;
  double left = 0;  // when the player went away; 0: it stayed to the end
};

// A player was brought to a part, in a copy of the running place.
struct Probe {
  InstanceId target = kNoInstance;  // the part, ClickDetector, prompt or tool
  Approach approach = Approach::stand;
  double at = 0;         // when the player arrived
  double left = 0;       // and went away; 0: stayed to the end
  Observation seen;      // from the arrival on
  SecondLook brief;      // of a part that harms again and again: the player leaves at once
  SecondLook still;      // of a part that harms once: the player stays and does not touch again
  bool lost = false;     // the copy died or ran out of time
  bool byPlace = false;  // no script listens to the part: what happens follows from the place
  bool allOver = true;   // it happens towards two opposite corners of the part, too
  bool byRoot = false;   // it does not happen where limbs alone are in the part
  bool byFall = false;   // it does something else to a player that falls on it from high above
  uint64_t listenerHash = 0;  // of the functions that listen to the part; 0: none do
  // The player died of the touch, or after one without effects, and lives again.
  bool sleeps = false;  // something that the touch began still waits at the end
  bool reborn = false;
  Vec3 rebornAt;  // the feet then
};

// A part that was not probed, as there are too many. The same functions listen to it as to a probed
// one.
struct SameListeners {
  InstanceId target = kNoInstance;
  uint32_t probe = 0;  // index into Report::probes
};

// Why a part does something else than at its first probe.
enum class Cause : uint8_t {
  again,   // it has been touched before
  time,    // time has passed, or the player has stayed
  lever,   // another part has been touched
  several  // several others have been touched, or it is not known which one
};

// A probe that differs from the first one of its part, once other parts have been touched.
struct Revisit {
  Probe probe;
  Cause cause = Cause::several;
  InstanceId lever = kNoInstance;  // the target of the other probe
};

// Jumps in the air between two floors that scripts give the player.
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
  std::vector<Probe> moves;    // of the player away from all parts, if scripts look at it
  double probedAt = 0;         // seconds, when the first probes began
  double lookedAgainAt = 0;    // and those of the second round; 0: there was none
  std::vector<MadePart> made;  // in the world by probedAt; then those made later
  std::vector<std::string> collisionGroups;  // that there are by then
  PlayerState arrived;                       // the player by then
  AirJumps airJumps;
  bool complete = false;             // the undisturbed run got to its end
  bool over = false;                 // and nothing goes on any more
  bool sleeps = false;               // scripts still wait for the first time
  std::string failure;               // why there is less than asked for: for people
  InstanceId culprit = kNoInstance;  // the script that ran when the child died
};

struct Plan {
  Settings settings;
  double seconds = 60;       // of the undisturbed run
  double probeAt = 3;        // seconds
  double probeSeconds = 12;  // of the longest probe
  size_t mostProbes = 600;
  double timeLimit = 60;  // seconds of the wall clock, for all: far above what the budgets allow
  size_t processes = 2;   // copies at a time
};

}  // namespace obby::engine
