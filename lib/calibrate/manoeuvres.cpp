#include "calibrate/manoeuvres.h"

#include "base/random.h"
#include "sim/simulator.h"

namespace obby::calibrate {

namespace {

constexpr float kSlippery = 0.02f, kIcy = 0.05f;  // frictions, below PhysicsParams::iceFriction

void set(schema::Vec3::Builder to, Vec3 v) {
  to.setX(v.x);
  to.setY(v.y);
  to.setZ(v.z);
}

struct Block {
  const char* name;
  Vec3 center, size;
  float friction = -1;  // negative: the usual
  bool truss = false;
};

constexpr Block kBlocks[] = {
    {"Ground", {0, -0.5f, 0}, {120, 1, 120}},
    {"Ice", {80, -0.5f, 0}, {40, 1, 120}, kSlippery},
    {"Less ice", {120, -0.5f, 0}, {40, 1, 120}, kIcy},
    {"Ledge", {-30, 4, 0}, {20, 8, 20}},
    {"Low ledge", {-16, 1, 0}, {8, 2, 20}},
    {"Wall", {0, 5, 40}, {20, 10, 2}},
    {"Truss", {0, 20, -40}, {2, 40, 2}, -1, true},
};

const char* nameOf(sim::State state) {
  switch (state) {
    case sim::State::running: return "Running";
    case sim::State::jumping: return "Jumping";
    case sim::State::freefall: return "Freefall";
    case sim::State::landed: return "Landed";
    case sim::State::climbing: return "Climbing";
    case sim::State::seated: return "Seated";
    case sim::State::fallingDown: return "FallingDown";
    case sim::State::dead: break;
  }
  return "Dead";
}

}  // namespace

void writeCourse(schema::Level::Builder level) {
  level.setName(kCourseName);
  auto parts = level.initParts(uint32_t(std::size(kBlocks)));
  for (uint32_t i = 0; i < parts.size(); ++i) {
    const Block& b = kBlocks[i];
    parts[i].setName(b.name);
    if (b.truss) parts[i].setShape(schema::Shape::TRUSS);
    set(parts[i].initPosition(), b.center);
    set(parts[i].initSize(), b.size);
    if (b.friction >= 0) parts[i].setFriction(b.friction);
  }
  auto spawn = level.initSpawns(1)[0];
  set(spawn.initPosition(), {0, 0, 0});
}

std::vector<Manoeuvre> manoeuvres() {
  return {
      {"run, stop, turn",
       {0, 0.1f, 0},
       {{0.5f, 0, 0},
        {1.5f, 0, -1},
        {0.7f, 0, 0},
        {1, 1, 0},
        {0.5f, -1, 0},
        {0.6f, 0, 1},
        {0.7f, 0, 0}}},
      {"jump on the spot", {0, 0.1f, 0}, {{0.5f, 0, 0}, {0.1f, 0, 0, true}, {1.4f, 0, 0}}},
      {"jump and turn back in the air",
       {0, 0.1f, 0},
       {{0.5f, 0, 0},
        {0.5f, 0, 1},
        {0.1f, 0, 1, true},
        {0.35f, 0, 1},
        {0.7f, 0, -1},
        {0.8f, 0, 0}}},
      {"hold jump", {0, 0.1f, 0}, {{0.5f, 0, 0}, {4, 1, 0, true}, {0.3f, -1, 0}, {0.7f, 0, 0}}},
      {"run and stop on ice",
       {55, 0.1f, 20},
       {{0.5f, 0, 0}, {1.5f, 1, 0}, {1.5f, 0, 0}, {2, 1, 0}, {1, 0, 1}, {1, 0, 0}}},
      {"walk off ledges",
       {-30, 8.1f, 0},
       {{0.3f, 0, 0}, {1.2f, 1, 0}, {1, 0, 0}, {0.6f, 1, 0}, {1, 0, 0}}},
      {"jump after the edge",
       {-30, 8.1f, 4},
       {{0.3f, 0, 0}, {0.65f, 1, 0}, {0.3f, 1, 0, true}, {1.5f, 1, 0}}},
      {"run into a wall", {0, 0.1f, 30}, {{0.3f, 0, 0}, {1, 0, 1}, {0.5f, 1, 1}, {0.5f, 0, 0}}},
      {"climb up and down",
       {0, 0.1f, -20},
       {{0.3f, 0, 0}, {2.5f, 0, -1}, {0.5f, 0, 0}, {1, 0, 1}, {1, 0, -1}}},
  };
}

Track rehearse(const level::Level& level, const Manoeuvre& manoeuvre, float noise, uint64_t seed) {
  const level::LevelView& view = level.view();
  const Params& p = view.params;
  sim::World world = sim::makeWorld(view, {manoeuvre.feet, 0, 0});
  std::vector<sim::LooseBody> loose = sim::makeLoose(view);
  Random random(seed, 0);
  const auto off = [&] { return noise * (2 * random.unit() - 1); };
  Track track{manoeuvre.name, level.name(), {}};
  for (const Hold& hold : manoeuvre.holds) {
    for (uint32_t t = ticksFromSeconds(p, hold.seconds); t > 0; --t) {
      Frame f;
      f.time = double(track.frames.size()) / p.controlRate;
      f.move = {hold.x, 0, hold.z};
      f.jump = hold.jump;
      f.position = rootOf(world.position, p) + Vec3{off(), off(), off()};
      f.velocity = world.velocity;
      f.state = world.state;
      track.frames.push_back(f);
      sim::advance(world, loose.data(), view, nullptr, actionOf(f));
    }
  }
  return track;
}

void writeRecording(const Track& track, schema::Recording::Builder to) {
  to.setName(track.name);
  to.setLevel(track.level);
  const double seconds = track.frames.back().time;
  to.setRate(float(double(track.frames.size() - 1) / seconds));
  auto frames = to.initFrames(uint32_t(track.frames.size()));
  for (uint32_t i = 0; i < frames.size(); ++i) {
    const Frame& f = track.frames[i];
    frames[i].setTime(f.time);
    set(frames[i].initMove(), f.move);
    frames[i].setJump(f.jump);
    set(frames[i].initPosition(), f.position);
    set(frames[i].initVelocity(), f.velocity);
    frames[i].setState(nameOf(f.state));
  }
}

}  // namespace obby::calibrate
