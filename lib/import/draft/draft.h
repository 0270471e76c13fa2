// The level as the importer builds it: plain structs with the schema's meaning. level_record.h
// turns it into a record. Units are those of schema/obby.capnp.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/document.h"
#include "math/vec.h"

namespace obby::importer {

class Tree;

// The order is the schema's.
enum class Shape : uint16_t { block, ball, cylinder, wedge, cornerWedge, truss, hull };
enum class Easing : uint16_t {
  linear,
  sine,
  back,
  quad,
  quart,
  quint,
  bounce,
  elastic,
  exponential,
  circular,
  cubic
};
enum class EasingDirection : uint16_t { in, out, inOut };
enum class Repeat : uint16_t { once, loop, pingPong };

struct Evidence {
  std::string role;
  std::string reason;
  bool guessed = false;
};

struct Kill {
  float damage = 100;
  float cooldown = 0;
  bool operator==(const Kill&) const = default;
};
struct Conveyor {
  Vec3 velocity;
  Vec3 angular;
  bool operator==(const Conveyor&) const = default;
};
struct JumpPad {
  Vec3 velocity;
  bool keepSideways = true;
  bool operator==(const JumpPad&) const = default;
};
constexpr float kGone = 3600;  // seconds: in effect for ever
struct Vanish {
  bool timer = false;
  std::string signal;     // signal that makes the part vanish; empty: its own touch
  bool inverted = false;  // solid while it would be gone, and gone otherwise
  float delay = 0;
  float away = 3;
  float phase = 0;
  bool operator==(const Vanish&) const = default;
};
struct Teleport {
  Vec3 position;  // feet
  float yaw = 0;
  bool turns = false;
  bool operator==(const Teleport&) const = default;
};
struct Boost {
  float walkSpeed = 1, jumpSpeed = 1, gravity = 1;  // factors of the player's own values
  float seconds = 0;  // duration after the last touch; 0: while touched
  bool forever = false;
  bool resets = false;  // a value of 1 restores the level's own
  bool operator==(const Boost&) const = default;
};
struct Trip {
  float seconds = 3;
  bool operator==(const Trip&) const = default;
};
struct Button {
  std::string signal;
  float seconds = 5;
  bool forever = false;
  bool restarts = false;  // a touch while the signal lasts restarts it
  bool operator==(const Button&) const = default;
};
enum class MotionTrigger : uint16_t { always, touch, signal };
struct MotionKey {
  float time = 0;
  Pose pose;
  Easing easing = Easing::linear;
  EasingDirection direction = EasingDirection::out;
  bool operator==(const MotionKey& other) const;
};
struct Spin {
  Vec3 axis = {0, 1, 0};
  float speed = 0;
  Vec3 pivot;
  bool operator==(const Spin&) const = default;
};
struct Motion {
  std::vector<MotionKey> keys;
  Repeat repeat = Repeat::loop;
  std::optional<Spin> spin;
  float offset = 0;
  bool carries = false;
  MotionTrigger trigger = MotionTrigger::always;
  std::string signal;
  bool operator==(const Motion&) const = default;
};

// Sources of a checkpoint's number, strongest first.
enum class NumberFrom : uint8_t {
  seen,    // a touch sets it
  asked,   // the part has no effect before others have been touched
  tag,     // "Checkpoint_3"
  value,   // an attribute or a value object
  name,    // the name of the part or of its model
  folder,  // "Stages/3"
  team,    // the name of the team
};
constexpr size_t kNumberSources = 7;
// Stage of a checkpoint without a number, until orderStages has run.
constexpr int kUnnumbered = -1;

// Facts about a checkpoint, collected before orderStages runs.
struct StageSigns {
  std::array<int, kNumberSources> numbers = {kUnnumbered, kUnnumbered, kUnnumbered, kUnnumbered,
                                             kUnnumbered, kUnnumbered, kUnnumbered};
  std::optional<int64_t> team;       // the colour of the team that a touch sets
  InstanceId respawn = kNoInstance;  // the SpawnLocation that it sets

  int& operator[](NumberFrom from) { return numbers[size_t(from)]; }
  int operator[](NumberFrom from) const { return numbers[size_t(from)]; }
};

struct PartShape {
  Shape shape = Shape::block;
  Pose pose;
  Vec3 size = {4, 1.2f, 2};
  std::vector<std::vector<Vec3>> hulls;
};

struct PartSurface {
  float friction = 0.3f, frictionWeight = 1, elasticity = 0.5f, density = 0.7f;
  ColorRgb color = {163, 162, 165};
  float transparency = 0;
  std::string_view material;  // as in the record
};

// The effects of a part on players.
struct PartRoles {
  std::optional<Kill> kill;
  std::optional<Conveyor> conveyor;
  std::optional<JumpPad> jumpPad;
  std::optional<Vanish> vanish;
  std::optional<Teleport> teleport;
  std::optional<Boost> boost;
  std::optional<Trip> trip;
  std::optional<Button> button;
  bool seat = false;
  bool oneWay = false;  // solid for players above it only
  bool climbable = false;
  std::optional<int> checkpoint;  // stage number
  std::optional<int> goal;        // stage number
  std::optional<Motion> motion;
};

struct PartDraft : PartShape, PartSurface, PartRoles {
  InstanceId id = kNoInstance;
  bool solid = true, touch = true, anchored = true;
  bool byRoot = false;     // touched by the centre of the root part only
  bool heardOnly = false;  // scripts listen to it, and a probe saw no effect
  StageSigns stageSigns;
  std::vector<Evidence> evidence;
  std::vector<std::string> doubts;  // kinds of losses that concern the part (doubts.h)
};

struct SpawnDraft {
  std::string name;
  int stage = 0;
  Vec3 position;  // feet
  float yaw = 0;
  int part = -1;  // index into LevelDraft::parts
};

struct UnmodelledDraft {
  uint32_t count = 0;
  std::string example;
  std::string note;
  bool anywhere = false;  // some instances concern no single part (doubts.h)
};

// An instance that the level models incompletely.
struct Loss {
  InstanceId at = kNoInstance;  // kNoInstance: the whole place
  std::string kind;
  auto operator<=>(const Loss&) const = default;
};

// Numbers of the world; fields are those of schema PhysicsParams.
struct World {
  float gravity = 196.2f;
  float walkSpeed = 16;
  float jumpSpeed = 53;
  float maxSlope = 1.5533431f;
  float maxHealth = 100;
  float healthRegeneration = 0.01f;
  float fallenPartsHeight = -500;
  uint16_t airJumps = 0;
};

// The bodies that a place gives to its players.
struct Avatar {
  std::vector<std::string> bodies;  // allowed names of level/bodies.h; empty: unspecified
  std::string body;                 // body of all players; empty: the default body
  float height = 1, width = 1;      // factors of the body's own size
  std::optional<Vec3> collider;  // size of the single box that collides, instead of torso and head
  bool colliderTouches = false;  // only the collider touches parts
};

struct LevelDraft {
  std::string name;
  std::string file, format, path;
  uint32_t partsRead = 0, partsCulled = 0;
  World world;
  Avatar avatar;
  std::vector<PartDraft> parts;
  std::vector<SpawnDraft> spawns;
  std::map<std::string, UnmodelledDraft> unmodelled;  // unmodelled instances by kind
  std::map<std::string, UnmodelledDraft> ignored;     // left out on purpose, for --explain

  std::set<Loss> losses;  // every instance that `unmodelled` counts

  // Counts one more instance of a kind that the simulator does not model. The first example and
  // note stay.
  void noteUnmodelled(const std::string& kind, const Tree& tree, InstanceId at,
                      const std::string& note);
  void noteIgnored(const std::string& kind, const std::string& example, const std::string& note) {
    count(ignored, kind, example, note);
  }

 private:
  static void count(std::map<std::string, UnmodelledDraft>& in, const std::string& kind,
                    const std::string& example, const std::string& note) {
    auto& entry = in[kind];
    if (entry.count++ == 0) {
      entry.example = example;
      entry.note = note;
    }
  }
};

}  // namespace obby::importer
