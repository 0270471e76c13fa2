// What was seen while a place's scripts ran: which properties changed on which instances, when, and
// by which line of which script. Times are seconds of the virtual clock since the run began.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "engine/document.h"
#include "math/vec.h"

namespace obby::engine {

constexpr double kFrame = 1.0 / 60;  // seconds: scripts resume, and poses are sampled, once a frame

// A script's line. `script` is the instance in the file; kNoInstance: nobody's, such as the engine.
struct Line {
  InstanceId script = kNoInstance;
  int line = 0;
  auto operator<=>(const Line&) const = default;
};

// Stands for the player's body and its Humanoid in changes.
constexpr InstanceId kPlayer = kNoInstance - 1;

// An instance that scripts have made has an id from kMade on.
constexpr InstanceId kMade = 0x40000000;

// An enum's item is its number; what has no other form is a monostate.
using Plain = std::variant<std::monostate, bool, double, std::string, Vec3, Pose>;

struct Change {
  double time = 0;
  InstanceId target = kNoInstance;
  std::string property;  // "Parent": true or false, whether the part is in the world
  Plain value;
  Line line;
};

// A part's pose at the end of a frame in which it has changed.
struct Placed {
  uint32_t frame = 0;
  Pose pose;
};

struct Track {
  Pose start;                 // before the first change
  std::vector<Placed> poses;  // ascending frames
  Line line;                  // the first that moved it
  // The constraint or mover that moves it; kNoInstance: scripts place it themselves.
  InstanceId driver = kNoInstance;
};

// A property that a tween changes.
struct TweenWay {
  std::string property;
  Plain from, to;
};

// A tween that began to play.
struct Tween {
  double time = 0;
  uint32_t id = 0;  // of the Tween
  InstanceId target = kNoInstance;
  double seconds = 1, delay = 0;
  uint32_t style = 0, direction = 0;  // items of Enum.EasingStyle and EasingDirection
  int repeats = 0;
  bool reverses = false;
  std::vector<TweenWay> ways;  // by their properties
  Line line;
};

struct Harm {
  double time = 0;
  double from = 0, to = 0;  // the player's health before and after
  Line line;
  bool stoppable = false;  // a force field stops it

  bool hurts() const { return to < from; }  // else it heals
};

// How an error that ends a script carries over to the game.
enum class Failure : uint8_t {
  refused,  // the engine raises it by its rules: it ends the script in the game, too
  usual,    // the script does something wrong, as it seems
  limited   // the script had used what the twin does not do: in the game it may go on
};

struct Problem {
  InstanceId script = kNoInstance;
  std::string text;
  int count = 0;
  Failure failure = Failure::usual;
};

// A script listens to an event of an instance, or looks at a value.
struct Heed {
  InstanceId target = kNoInstance;
  Line line;
};

// A part that scripts have made or copied; or a joint, constraint, mover or attachment.
struct MadePart {
  InstanceId id = kNoInstance, origin = kNoInstance;  // `origin`: what it is a copy of, if anything
  InstanceId parent = kNoInstance;
  std::string className, name;
  std::map<std::string, Plain> properties;  // those that differ from the class's defaults
  std::map<std::string, InstanceId> references;
  bool later = false;  // made after the first probes
};

// Where the player is and what it can do.
struct PlayerState {
  Vec3 feet, velocity;
  double health = 100, maxHealth = 100, walkSpeed = 16, jumpPower = 50, jumpHeight = 7.2;
  double gravity = 196.2, lift = 0;  // studs/s^2: of Workspace; what forces take from it
  bool usesJumpPower = true, alive = false;
  bool stuck = false;  // cannot walk
};

struct Observation {
  std::vector<Change> changes;
  std::map<InstanceId, Track> tracks;
  std::vector<Tween> tweens;
  std::vector<Harm> harms;
  std::vector<Problem> problems;
  std::map<std::string, int> counts;  // "method BasePart:X": what the twin does not do, how often
  // Events and values of the engine, like "Humanoid.Jumping", since the run began: those that
  // scripts heed, and those that have happened or varied.
  std::map<std::string, std::vector<Heed>> heeded;
  std::map<std::string, bool> happened;
  bool random = false;  // scripts have drawn random numbers since the start
  PlayerState player;   // at the end
  uint32_t frames = 0;
};

}  // namespace obby::engine
