// Changes that a place's scripts make: which property of which instance, when, and by which line of
// which script. Times are seconds of the virtual clock since the run began.
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

// A script's line. `script` is the instance in the file; kNoInstance for the engine.
struct Line {
  InstanceId script = kNoInstance;
  int line = 0;
  auto operator<=>(const Line&) const = default;
};

// Stands for the player's body and its Humanoid in changes.
constexpr InstanceId kPlayer = kNoInstance - 1;

// Instances made by scripts have ids from kMade on.
constexpr InstanceId kMade = 0x40000000;

// An enum's item is its number; a monostate is a value without a plain form.
using Plain = std::variant<std::monostate, bool, double, std::string, Vec3, Pose>;

struct Change {
  double time = 0;
  InstanceId target = kNoInstance;
  std::string property;  // "Parent": true if the part is in the world
  Plain value;
  Line line;
};

// A part's pose at the end of a frame that changed it.
struct Placed {
  uint32_t frame = 0;
  Pose pose;
};

struct Track {
  Pose start;                 // before the first change
  std::vector<Placed> poses;  // ascending frames
  Line line;                  // first line that moved the part
  // The constraint or mover that moves it; kNoInstance if scripts place it themselves.
  InstanceId driver = kNoInstance;
};

// A property that a tween changes.
struct TweenChange {
  std::string property;
  Plain from, to;
};

// A tween that began to play.
struct Tween {
  double time = 0;
  uint32_t id = 0;  // id of the Tween
  InstanceId target = kNoInstance;
  double seconds = 1, delay = 0;
  uint32_t style = 0, direction = 0;  // items of Enum.EasingStyle, EasingDirection
  int repeats = 0;
  bool reverses = false;
  std::vector<TweenChange> changes;  // one for each property
  Line line;
};

struct Harm {
  double time = 0;
  double from = 0, to = 0;  // the player's health before and after
  Line line;
  bool stoppable = false;  // a force field stops it

  bool hurts() const { return to < from; }  // else it heals
};

// Classes of errors that end a script, by what they mean for the real game.
enum class Failure : uint8_t {
  refused,  // the engine's rules forbid it: it ends the script in the game, too
  usual,    // probably a bug of the script
  limited   // unsupported feature: in the game the script may go on
};

struct Problem {
  InstanceId script = kNoInstance;
  std::string text;
  int count = 0;
  Failure failure = Failure::usual;
};

// A script that listens to an event of an instance, or reads a value.
struct Heed {
  InstanceId target = kNoInstance;
  Line line;
};

// A part, joint, constraint, mover or attachment that scripts have made or copied.
struct MadePart {
  InstanceId id = kNoInstance, origin = kNoInstance;  // `origin`: source of the copy, if any
  InstanceId parent = kNoInstance;
  std::string className, name;
  std::map<std::string, Plain> properties;  // those that differ from the defaults
  std::map<std::string, InstanceId> references;
  bool later = false;  // made after the first probes
};

// State of the player, and its speeds.
struct PlayerState {
  Vec3 feet, velocity;
  double health = 100, maxHealth = 100, walkSpeed = 16, jumpPower = 50, jumpHeight = 7.2;
  double gravity = 196.2, lift = 0;  // studs/s^2: Workspace's gravity; share that forces cancel
  bool usesJumpPower = true, alive = false;
  bool stuck = false;  // cannot walk
};

struct Observation {
  std::vector<Change> changes;
  std::map<InstanceId, Track> tracks;
  std::vector<Tween> tweens;
  std::vector<Harm> harms;
  std::vector<Problem> problems;
  std::map<std::string, int> counts;  // uses of unsupported features, "method BasePart:X"
  // Events and values of the engine, such as "Humanoid.Jumping", since the run began. heeded: those
  // that scripts watch. happened: those that occurred or varied.
  std::map<std::string, std::vector<Heed>> heeded;
  std::map<std::string, bool> happened;
  bool random = false;  // scripts have drawn random numbers
  PlayerState player;   // state at the end
  uint32_t frames = 0;
};

}  // namespace obby::engine
