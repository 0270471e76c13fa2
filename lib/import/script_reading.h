// What a script's text says about the world: which properties it sets on which parts, when, and
// what sets it off. Nothing is executed: the text is parsed and followed with the values it states,
// within a step budget; what a script does not state stays unknown (luau/reader.h).
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "import/draft.h"
#include "import/line_index.h"
#include "import/tree.h"

namespace obby::importer {

struct TweenTiming {
  double seconds = 1;
  Easing easing = Easing::quad;
  EasingDirection direction = EasingDirection::out;
  int repeats = 0;  // -1: for ever
  bool reverses = false;
  double delay = 0;
  bool known = true;  // the text tells all of it

  // Seconds from Play to Completed; of an endless one, of its first round.
  double total() const {
    return delay + seconds * (reverses ? 2 : 1) * (repeats < 0 ? 1 : repeats + 1);
  }
};

enum class EventKind {
  set,        // a property of a known instance gets a value; its Parent: `flag` where that puts it
              // back into the world, nothing where the place is not known
  tween,      // a known instance is tweened: one event for the pose, one for each other goal
  destroy,    // a known instance leaves the world, destroyed or not
  damage,     // a character loses `number` health (NaN: the text does not tell how much), or all;
              // outside of a touch `target` is the part whose contents the script asked for
  push,       // a character's velocity is set to `vector` (NaN components are kept)
  teleport,   // a character is moved to `frame` (NaN where unknown)
  character,  // another property of a character or player is set
  respawnAt,  // the place where a player comes back is set
  build,      // an instance made by the script is put into the world
};

struct ScriptEvent {
  EventKind kind = EventKind::set;
  InstanceId target = kNoInstance;
  std::string property;
  std::optional<double> number;
  std::optional<bool> flag;
  std::optional<Vec3> vector;
  std::optional<Pose> frame;
  std::optional<Vec3> orientation;  // degrees, of a tween whose goal states them: how `frame` turns
  InstanceId from = kNoInstance;    // the instance whose pose the value is, unchanged
  bool places = true, turns = true;  // of a pose: sets where the target is, which way it is turned
  TweenTiming tween;
  double until = std::numeric_limits<double>::infinity();  // when the script stops the tween
  double done = 0;  // seconds that the tween had gone on before a pause, if it goes on after one
  int which = 0;    // of a tween: which one of the script's
  double time = 0;  // seconds after the trigger; of what each frame does, after the start
  bool unsure = false;  // under a condition that the text does not decide
  int line = 0;
  int onceLine = 0;  // of a touch: that of the flag which lets it come but once; 0: it comes again

  // Of an amount that the text does not tell, too: `number` is NaN then, and nothing if it kills.
  bool harms() const { return kind == EventKind::damage && !(number && *number <= 0); }
};

enum class Trigger {
  start,  // runs by itself
  touch,  // a part is touched
  frame,  // every 1/60 s
  other,  // clicked, a player joins, a value changes
};

// What follows one trigger, in the order of time.
struct Timeline {
  Trigger trigger = Trigger::start;
  InstanceId touched = kNoInstance;  // the part, for touch
  std::string signal;                // "Touched", "CharacterAdded"; empty for start
  int line = 0;                      // where it is connected
  std::vector<ScriptEvent> events;
  double end = 0;        // seconds from the trigger to the last line
  bool forever = false;  // ends in an endless loop
  double loopStart = 0;  // seconds; with `forever`
  size_t loopEvent = 0;  // index of the first event of the loop
  double period = 0;     // seconds of one round of the loop (or of all that were followed)
  bool closed = false;   // after `period` the parts are back where the loop began
  bool maybe = false;    // begun or connected under a condition that the text does not decide
  bool vague = false;    // waits for a time that the text does not tell: taken as the shortest
  // Index of the first event behind a loop that waits until something holds which the text does not
  // tell, and that was passed over.
  size_t awaits = std::numeric_limits<size_t>::max();
  int cutLine = 0;  // the line that disconnects its handler at some time; 0: it goes on for ever
  // Only the harm that a handler does once something has changed in play, as an earlier touch may
  // have; another timeline has what it does before.
  bool again = false;

  // Whether it comes as the game runs, whatever players do.
  bool byItself() const { return trigger == Trigger::start || trigger == Trigger::frame; }
  // Whether something is touched, or a zone entered, and the text does not tell what.
  bool ofUnknownTouch() const;
};

struct ScriptReading {
  InstanceId script = kNoInstance;
  std::vector<Timeline> timelines;
  LineIndex lines;             // of the source, for evidence: the document must outlive it
  bool broken = false;         // the text could not be parsed to the end
  bool requiresAsset = false;  // require(number): code that is not in the file
  bool dynamicCode = false;    // loadstring, getfenv, setfenv
  bool exhausted = false;      // a budget cut the reading: of steps, rounds, calls or room
  bool cutAgain = false;       // or what comes last of it: see Timeline::again
  bool cutChanges = false;     // it sets more than other scripts are told: luau::kMaxKeys
  bool givesParents = false;   // the text gives something another parent, not nil
  bool makesJoints = false;    // the text names joints
  std::vector<int> waysOut;    // lines of them, out of loops that were taken as endless: what
                               // follows those was not read
  std::string enabledBy;       // scriptReason of what may enable it; empty: the file does

  // Whether it may never run, or not before another script enables it.
  bool isWoken() const { return !enabledBy.empty(); }
  // Whether what one of its timelines does may come but later on, or never: a guess.
  bool isLater(const Timeline& timeline) const { return timeline.again || isWoken(); }
};

// The most events and timelines of a place, but for the timeline that each script has of itself:
// half a gigabyte. The steps that a place may take are 20,000,000, and a loop that moves parts
// takes ten of them for each; a crafted text has an event each step, or an empty handler each six.
constexpr size_t kScriptRoom = 2000000;

// Reads every script that runs in the place. Disabled ones are read, after the others, where
// another script may enable them (woken_scripts.h); those in storage do nothing. Each is read for
// itself; what others set counts only for the timelines that are `again`. Of all events and
// timelines the first are kept that there is `room` for; a script that has more is `exhausted`, or
// `cutAgain`.
std::vector<ScriptReading> readScripts(const Tree& tree, size_t room = kScriptRoom);

// True for the scripts that each new character gets.
bool isInStarterCharacter(const Tree& tree, InstanceId id);

// "script KillScript line 3: hit.Parent.Humanoid.Health = 0"
std::string scriptReason(const Tree& tree, const ScriptReading& reading, int line);

}  // namespace obby::importer
