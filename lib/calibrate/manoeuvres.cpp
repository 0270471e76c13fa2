#include "calibrate/manoeuvres.h"

#include <algorithm>

#include "base/random.h"
#include "level/record_values.h"
#include "level/rotation.h"
#include "sim/simulator.h"

namespace obby::calibrate {

namespace {

using level::set;

std::vector<sim::ActionRun> actionsOf(const Manoeuvre& manoeuvre, const Params& params) {
  std::vector<sim::ActionRun> out;
  for (const Hold& h : manoeuvre.holds)
    out.push_back(
        {actionOf({0, {h.x, 0, h.z}, h.jump, {}, {}}), ticksFromSeconds(params, h.seconds)});
  return out;
}

// Lists each moving or dynamic part once.
void showMoving(const level::Level& level, Track& track) {
  for (uint32_t i = 0; i < level.view().colliderCount; ++i) {
    const level::Collider& c = level.view().colliders[i];
    const bool again =
        std::find(track.parts.begin(), track.parts.end(), c.part) != track.parts.end();
    if (again || (c.mover == level::kNone && c.body == level::kNoBody)) continue;
    track.parts.push_back(c.part);
    track.shown.push_back("part:" + std::to_string(c.part));
  }
}

PartPose poseOf(const level::LevelView& level, uint32_t part, uint32_t tick,
                const std::vector<sim::RigidBody>& bodies) {
  const auto* const end = level.colliders + level.colliderCount;
  const level::Collider& c =
      *std::find_if(level.colliders, end, [&](const level::Collider& x) { return x.part == part; });
  if (c.body != level::kNoBody)
    return {sim::poseOf(bodies[c.body], level.bodies[c.body]).position, bodies[c.body].rotation};
  const Pose pose = level::moverPose(level.movers[c.mover], tick);
  return {pose.position, toQuat(pose.rotation)};
}

// Writes the poses unless they equal those of the previous frame.
void writePoses(const Track& track, uint32_t frame, schema::RecordingFrame::Builder to) {
  const auto moved = [&](size_t i) {
    const PartPose &now = track.pose(frame, i), &before = track.pose(frame - 1, i);
    const Quat a = now.rotation, b = before.rotation;
    return !(now.position == before.position) || a.x != b.x || a.y != b.y || a.z != b.z ||
           a.w != b.w;
  };
  bool any = frame == 0;
  for (size_t i = 0; i < track.shown.size() && !any; ++i) any = moved(i);
  if (!any) return;
  auto poses = to.initPoses(uint32_t(track.shown.size()));
  for (uint32_t i = 0; i < poses.size(); ++i) {
    set(poses[i].initPosition(), track.pose(frame, i).position);
    set(poses[i].initRotation(), track.pose(frame, i).rotation);
  }
}

}  // namespace

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
      {"turn a little and about",
       {0, 0.1f, 0},
       {{0.5f, 0, 0},
        {0.3f, 0, -1},
        {0.3f, 0.3f, -1},
        {0.3f, 1, -1},
        {0.5f, 0, 0},
        {0.2f, -1, 0},
        {0.6f, 0, 0},
        {0.5f, 0, 1}}},
      {"jump over gaps",
       {-56, 0.1f, -90},
       {{0.4f, 0, 0},
        {0.68f, 1, 0},
        {0.1f, 1, 0, true},
        {1.0f, 1, 0},
        {0.1f, 1, 0, true},
        {1.08f, 1, 0},
        {0.1f, 1, 0, true},
        {1.16f, 1, 0},
        {0.1f, 1, 0, true},
        {0.8f, 1, 0},
        {0.4f, 0, 0}}},
      {"jump onto a 5-stud step",
       {-10, 0.1f, 80},
       {{0.4f, 0, 0}, {0.1f, 0, 1}, {0.1f, 0, 1, true}, {0.55f, 0, 1}, {0.6f, 0, 0}}},
      {"jump onto a 7-stud step",
       {4, 0.1f, 80},
       {{0.4f, 0, 0}, {0.1f, 0, 1}, {0.1f, 0, 1, true}, {0.55f, 0, 1}, {0.6f, 0, 0}}},
      {"jump at an 8.5-stud step",
       {18, 0.1f, 80},
       {{0.4f, 0, 0}, {0.1f, 0, 1}, {0.1f, 0, 1, true}, {0.55f, 0, 1}, {0.6f, 0, 0}}},
      {"walk up a 21-degree ramp", {-50, 0.1f, 84}, {{0.3f, 0, 0}, {1.1f, 0, 1}, {0.6f, 0, 0}}},
      {"walk up a 41-degree ramp", {-38, 0.1f, 85}, {{0.3f, 0, 0}, {1, 0, 1}, {0.6f, 0, 0}}},
      {"walk up a 61-degree ramp", {-26, 0.1f, 86}, {{0.3f, 0, 0}, {1, 0, 1}, {0.6f, 0, 0}}},
      {"ride the belt",
       {-85, 0.1f, -6},
       {{0.8f, 0, 0}, {1, 0, -1}, {0.5f, 1, 0}, {0.1f, 0, 0, true}, {0.8f, 0, 0}, {0.8f, 0, 1}}},
      {"ride the ferry",
       {-120, 0.1f, -35},
       {{1.5f, 0, 0},
        {0.15f, 1, 0},
        {1, 0, 0},
        {0.1f, 0, 0, true},
        {0.8f, 0, 0},
        {0.1f, -1, 0},
        {0.8f, 0, 0}}},
      {"push the box", {-12, 0.1f, -25}, {{0.4f, 0, 0}, {2, 1, 0}, {0.6f, 0, 0}}},
  };
}

Track rehearse(const level::Level& level, const Manoeuvre& manoeuvre, float noise, uint64_t seed) {
  const level::LevelView& view = level.view();
  const Params& p = view.params;
  sim::World world = sim::makeWorld(view, {manoeuvre.feet, 0, 0});
  std::vector<sim::RigidBody> bodies = sim::startBodies(view);
  Random random(seed, 0);
  const auto off = [&] { return noise * (2 * random.unit() - 1); };
  Track track{manoeuvre.name, level.name()};
  showMoving(level, track);
  for (const Hold& hold : manoeuvre.holds) {
    for (uint32_t t = ticksFromSeconds(p, hold.seconds); t > 0; --t) {
      Frame f;
      f.time = double(track.frames.size()) / p.controlRate;
      f.move = {hold.x, 0, hold.z};
      f.jump = hold.jump;
      f.position = rootOf(world.position, p) + Vec3{off(), off(), off()};
      f.velocity = world.velocity;
      f.state = world.state;
      f.facing = directionOf(sinCos(world.yaw));
      track.frames.push_back(f);
      for (const uint32_t part : track.parts)
        track.poses.push_back(poseOf(view, part, world.tick, bodies));
      sim::advance(world, bodies.data(), view, nullptr, actionOf(f));
    }
  }
  return track;
}

void writePlan(const level::Level& level, const Manoeuvre& manoeuvre,
               schema::Trajectory::Builder to) {
  const sim::Plan plan{{manoeuvre.feet, 0, 0}, 0, actionsOf(manoeuvre, level.view().params)};
  const sim::ReplayEnd end =
      sim::replay(level.view(), nullptr, plan, [](const sim::Moment&) { return true; });
  to.setQuery(manoeuvre.name);
  to.setLevel(level.name());
  sim::writePlan(plan, to);
  to.setOutcome(schema::Outcome(end.world.outcome));
  to.setTicks(end.ticks);
  to.setJumps(end.world.jumps);
  to.setStateHash(sim::stateHash(end.world, end.bodies));
  set(to.initEndPosition(), end.world.position);
}

void writeRecording(const Track& track, schema::Recording::Builder to) {
  to.setName(track.name);
  to.setLevel(track.level);
  const double seconds = track.frames.back().time;
  to.setRate(float(double(track.frames.size() - 1) / seconds));
  to.setEngine("obby's own simulator");
  auto shown = to.initParts(uint32_t(track.shown.size()));
  for (uint32_t i = 0; i < shown.size(); ++i) shown.set(i, track.shown[i]);
  auto frames = to.initFrames(uint32_t(track.frames.size()));
  for (uint32_t i = 0; i < frames.size(); ++i) {
    const Frame& f = track.frames[i];
    frames[i].setTime(f.time);
    set(frames[i].initMove(), f.move);
    frames[i].setJump(f.jump);
    set(frames[i].initPosition(), f.position);
    set(frames[i].initVelocity(), f.velocity);
    frames[i].setState(nameOf(f.state));
    set(frames[i].initFacing(), f.facing);
    writePoses(track, i, frames[i]);
  }
}

}  // namespace obby::calibrate
