#include "calibrate/course_level.h"

#include "level/record_values.h"

namespace obby::calibrate {

namespace {

constexpr float kSlippery = 0.02f, kIcy = 0.05f;  // frictions
constexpr float kUsual = -1;

struct Block {
  const char* name;
  Vec3 center, size;
  float friction = kUsual;
  schema::Shape shape = schema::Shape::BLOCK;
};

constexpr Block kBlocks[] = {
    {"Ground", {0, -0.5f, 0}, {120, 1, 120}},
    {"Ice", {80, -0.5f, 0}, {40, 1, 120}, kSlippery},
    {"Less ice", {120, -0.5f, 0}, {40, 1, 120}, kIcy},
    {"Ledge", {-30, 4, 0}, {20, 8, 20}},
    {"Low ledge", {-16, 1, 0}, {8, 2, 20}},
    {"Wall", {0, 5, 40}, {20, 10, 2}},
    {"Truss", {0, 20, -40}, {2, 40, 2}, kUsual, schema::Shape::TRUSS},
    // Gaps of 5, 7, 8 and 8.5 studs.
    {"Pit", {0, -10.5f, -90}, {150, 1, 50}},
    {"Stone 1", {-52, -0.5f, -90}, {16, 1, 8}},
    {"Stone 2", {-33, -0.5f, -90}, {12, 1, 8}},
    {"Stone 3", {-14, -0.5f, -90}, {12, 1, 8}},
    {"Stone 4", {6, -0.5f, -90}, {12, 1, 8}},
    {"Stone 5", {29.5f, -0.5f, -90}, {18, 1, 8}},
    // Steps of 5, 7 and 8.5 studs, and ramps of 21, 41 and 61 degrees.
    {"Yard", {0, -0.5f, 90}, {120, 1, 50}},
    {"Step of 5", {-10, 2.5f, 92}, {8, 5, 10}},
    {"Step of 7", {4, 3.5f, 92}, {8, 7, 10}},
    {"Step of 8.5", {18, 4.25f, 92}, {8, 8.5f, 10}},
    {"Ramp of 21", {-50, 3, 96}, {8, 6, 16}, kUsual, schema::Shape::WEDGE},
    {"Ramp of 41", {-38, 6, 96}, {8, 12, 14}, kUsual, schema::Shape::WEDGE},
    {"Ramp of 61", {-26, 8, 94}, {8, 16, 9}, kUsual, schema::Shape::WEDGE},
    {"Beside the belt", {-85, -0.5f, 30}, {50, 1, 40}},
    {"Under the ferry", {-100, -8.5f, -35}, {80, 1, 50}},
};

void fill(schema::Part::Builder part, const char* name, Vec3 center, Vec3 size) {
  part.setName(name);
  level::set(part.initPosition(), center);
  level::set(part.initSize(), size);
}

void writeBelt(schema::Part::Builder part) {
  fill(part, "Belt", {-85, -0.5f, 0}, {50, 1, 20});
  level::set(part.initConveyor().initVelocity(), {0, 0, 8});
}

void writeFerry(schema::Part::Builder part) {
  const Vec3 from{-120, -0.5f, -35}, to{-80, -0.5f, -35};
  fill(part, "Ferry", from, {10, 1, 10});
  auto motion = part.initMotion();
  motion.setCarries(true);
  motion.setRepeat(schema::Repeat::PING_PONG);
  auto keys = motion.initKeys(2);
  level::set(keys[0].initPosition(), from);
  level::set(keys[1].initPosition(), to);
  keys[1].setTime(4);
  for (auto key : keys) {
    key.setEasing(schema::Easing::SINE);
    key.setDirection(schema::EasingDirection::IN_OUT);
  }
}

void writeBox(schema::Part::Builder part) {
  fill(part, "Box", {-4, 1.5f, -25}, {3, 3, 3});
  part.setAnchored(false);
  part.setDensity(0.3f);
}

}  // namespace

void writeCourse(schema::Level::Builder level) {
  level.setName(kCourseName);
  const uint32_t count = uint32_t(std::size(kBlocks));
  auto parts = level.initParts(count + 3);
  for (uint32_t i = 0; i < count; ++i) {
    const Block& b = kBlocks[i];
    fill(parts[i], b.name, b.center, b.size);
    parts[i].setShape(b.shape);
    if (b.friction >= 0) parts[i].setFriction(b.friction);
  }
  writeBelt(parts[count]);
  writeFerry(parts[count + 1]);
  writeBox(parts[count + 2]);
  level::set(level.initSpawns(1)[0].initPosition(), {0, 0, 0});
}

}  // namespace obby::calibrate
