// A part of a generated level as plain values. Records and place files are written from it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "math/vec.h"
#include "schema/obby.capnp.h"

namespace obby::gen {

struct Color {
  uint8_t r, g, b;
};

struct VanishSketch {
  schema::VanishTrigger trigger = schema::VanishTrigger::TOUCH;
  float delay = 0, away = 3, phase = 0;  // seconds, as in the schema
  bool inverted = false;
};

struct ButtonSketch {
  float seconds;
};

struct MotionSketch {
  struct Key {
    float time;  // seconds
    Vec3 position;
  };
  std::vector<Key> keys;  // there and back; empty: does not move
  bool smooth = true;     // sine in and out, else linear
  float offset = 0;       // seconds
  bool carries = false;
  Vec3 spinAxis{0, 1, 0}, spinPivot;  // in the part's frame
  float spin = 0;                     // rad/s; 0: none
};

// The fields are those of the schema's Part.
struct PartSketch {
  std::string name;
  schema::Shape shape = schema::Shape::BLOCK;
  Vec3 position;
  Quat rotation;
  Vec3 size;
  Color color{};
  float transparency = 0;
  float friction = -1, density = -1;  // negative: the schema's default
  float frictionWeight = 1;           // weight of `friction` in the mean with the player's friction
  bool solid = true, anchored = true, kill = false, goal = false;
  int32_t checkpoint = 0;  // stage; 0: none
  Vec3 conveyor, pad;      // studs/s; zero: none
  std::optional<VanishSketch> vanish;
  std::optional<ButtonSketch> button;
  std::optional<MotionSketch> motion;
  std::string signal;  // name shared by a button and the parts that the button controls

  PartSketch& shaped(schema::Shape s) { return shape = s, *this; }
  PartSketch& colored(Color c) { return color = c, *this; }
  PartSketch& turned(Quat local) { return rotation = rotation * local, *this; }
  PartSketch& moving(MotionSketch m) { return motion = std::move(m), *this; }
  PartSketch& vanishing(VanishSketch v) { return vanish = v, *this; }
};

// Rotations about the part's own axes.
constexpr float kHalfRoot = 0.70710678f;
constexpr Quat kUpright{0, 0, kHalfRoot, kHalfRoot};  // turns a cylinder's axis up
constexpr Quat kAlong{0, kHalfRoot, 0, kHalfRoot};    // turns a cylinder's axis along the route
constexpr Quat kAbout{0, 1, 0, 0};                    // half turn: front to back

namespace colors {
constexpr Color kStart{88, 181, 106}, kGoal{66, 135, 245}, kCheckpoint{122, 205, 152};
constexpr Color kKill{226, 61, 46}, kMoving{245, 196, 66}, kWood{160, 110, 60};
constexpr Color kWall{120, 126, 140}, kSteel{150, 158, 173}, kIce{170, 220, 245};
constexpr Color kBelt{72, 78, 92}, kPad{168, 110, 230}, kFading{240, 142, 52};
constexpr Color kButton{240, 90, 160}, kBeat[2] = {{255, 140, 105}, {110, 190, 255}};
}  // namespace colors

}  // namespace obby::gen
