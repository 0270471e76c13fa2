// When a thing that a script does to parts takes place: as play starts, or some time later, or
// perhaps never.
#pragma once

#include <set>
#include <string>

#include "import/script_reading.h"

namespace obby::importer {

constexpr double kAtOnce = 1e-3;  // seconds: less than a frame

enum class Onset {
  atStart,    // at once, for certain and for every player
  ofAClient,  // at once and for certain, but only where the player's own client runs the script
  later,      // after a wait, in an endless loop, over the time of a tween
  unsure,     // the text does not tell whether, or to what
};

// Whether the event changes parts in a way that a player meets or sees: CanCollide, CanTouch,
// Anchored, Transparency, a size, a pose, Destroy, Parent. Parts below its target may not be in the
// level.
bool changesParts(const Tree& tree, const ScriptEvent& event);

// Whether it sets the size of a part, however that is spelled.
bool isSize(const ScriptEvent& event);

// Whether the event puts something back into the world that had left it.
bool comesBack(const ScriptEvent& event);

// Whether the event comes round again for as long as the game runs.
bool isLooped(const Timeline& timeline, size_t event);

// The onsets of one script's events.
class Onsets {
 public:
  Onsets(const Tree& tree, const ScriptReading& reading);

  // Whether the player's own client runs the script.
  bool areOfAClient() const { return onClient_; }
  // Of an event for which changesParts holds, or that sets a property of a constraint.
  Onset of(const Timeline& timeline, size_t event) const;

 private:
  bool isDoubtful(const ScriptEvent& event) const;

  const Tree& tree_;
  bool onClient_ = false;
  bool givesParents_ = false, makesJoints_ = false;
  std::set<std::string> built_;    // classes of what it puts into the world by itself
  std::set<InstanceId> returned_;  // what it puts back at once or by the clock
};

}  // namespace obby::importer
