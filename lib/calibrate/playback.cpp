#include "calibrate/playback.h"

#include <algorithm>
#include <cmath>

#include "calibrate/surroundings.h"

namespace obby::calibrate {

namespace {

// A window in progress. It begins earlier and follows the track tick by tick, which yields state
// that no frame records: the facing, and the time since a floor was sensed.
struct Player {
  const Track& track;
  Window window;
  double origin;  // time of the track at tick 0
  int tick;       // negative: before the window
  sim::World world;
  std::vector<sim::RigidBody> bodies;
  uint32_t held = 0;  // frame whose input is active
  uint32_t next = 0;  // next frame to compare
  Moment before = {};

  bool over() const { return next > window.last; }

  sim::Action actionAt(double time) {
    while (held + 1 < track.frames.size() && track.frames[held + 1].time <= time) ++held;
    while (held > 0 && track.frames[held].time > time) --held;
    return actionOf(track.frames[held]);
  }
};

constexpr double kLead = 0.4;  // seconds that are played before a window

bool showsFacing(const Frame& f) { return f.facing.x != 0 || f.facing.z != 0; }

// Sets a player's state to that of a recorded frame.
void hold(Player& player, uint32_t frame, const level::LevelView& level) {
  const Frame& f = player.track.frames[frame];
  player.world.position = feetOf(f, level.params);
  player.world.velocity = f.velocity;
  player.world.state = f.state;
  if (showsFacing(f)) player.world.yaw = headingOf(f.facing.x, f.facing.z);
  if (showBodies(player.track, frame, level, player.bodies)) player.world.flags |= sim::kBodyAwake;
}

Moment momentOf(const sim::World& world, const Params& p) {
  return {rootOf(world.position, p), world.velocity, directionOf(sinCos(world.yaw)), world.state};
}

Moment between(const Moment& a, const Moment& b, float share) {
  const auto mix = [share](Vec3 x, Vec3 y) { return x + (y - x) * share; };
  return {mix(a.position, b.position), mix(a.velocity, b.velocity), mix(a.facing, b.facing),
          share < 0.5f ? a.state : b.state};
}

uint32_t nearestFrame(const Track& track, uint32_t from, double time) {
  while (from > 0 && track.frames[from].time > time) --from;
  const bool later = from + 1 < track.frames.size() &&
                     track.frames[from + 1].time - time < time - track.frames[from].time;
  return later ? from + 1 : from;
}

}  // namespace

std::vector<Window> windowsOf(const Track& track, double seconds, const level::LevelView& level) {
  const uint32_t end = uint32_t(track.frames.size()) - 1;
  if (!showsBodies(track, level)) return {{0, end}};
  std::vector<Window> out;
  for (uint32_t first = 0; first < end;) {
    uint32_t last = first + 1;
    while (last < end && track.frames[last].time - track.frames[first].time < seconds) ++last;
    out.push_back({first, last});
    first = last;
  }
  return out;
}

namespace {

// A standing player faces the last move direction. A climbing one faces the move direction on
// arrival at the truss.
Turns facingAt(const Track& track, uint32_t index) {
  const Vec3 facing = track.frames[index].facing;
  if (showsFacing(track.frames[index])) return headingOf(facing.x, facing.z);
  while (index > 0 && track.frames[index].state == sim::State::climbing) --index;
  while (index > 0 && !actionOf(track.frames[index]).walk) --index;
  return actionOf(track.frames[index]).heading;
}

}  // namespace

sim::World worldAt(const Track& track, uint32_t index, const level::LevelView& level) {
  const Params& p = level.params;
  const Frame& f = track.frames[index];
  sim::World w = sim::makeWorld(level, {feetOf(f, p), 0, track.tickAt(f.time, p)});
  w.velocity = f.velocity;
  w.state = f.state;
  w.yaw = facingAt(track, index);
  const auto grounded = [](sim::State s) {
    return s == sim::State::running || s == sim::State::landed;
  };
  uint32_t since = index;
  while (since > 0 && !grounded(track.frames[since].state)) --since;
  if (grounded(track.frames[since].state)) {
    const uint64_t ticks = wholeTicks(f.time - track.frames[since].time, p);
    w.floorlessSteps = uint16_t(std::min<uint64_t>(ticks * p.substeps, 0xffff));
  }
  if (w.floorlessSteps == 0) w.flags |= sim::kFloorSensed;
  if (f.state != sim::State::landed) return w;
  uint32_t landed = index;
  while (landed > 0 && track.frames[landed - 1].state == sim::State::landed) --landed;
  // The landing tick counts.
  const int64_t ticks = 1 + int64_t(wholeTicks(f.time - track.frames[landed].time, p));
  w.landedSteps = uint8_t(std::max<int64_t>(p.landedSteps - ticks * p.substeps, 0));
  return w;
}

namespace {

Player playerOf(const Track& track, const Window& window, const level::LevelView& level) {
  const double origin = track.frames[window.first].time;
  const int lead = int(wholeTicks(std::min(kLead, origin), level.params));
  const double begin = origin - lead * double(level.params.tickSeconds);
  const uint32_t first = nearestFrame(track, window.first, begin);
  sim::World world = worldAt(track, first, level);
  // The frame may be some ticks off, but moving parts follow the exact time.
  world.tick = track.tickAt(begin, level.params);
  return {track, window, origin, -lead, world, sim::startBodies(level), first, window.first + 1};
}

// Visits the frames passed in the last tick.
void meetFrames(Player& player, const Params& p, uint32_t number, const Visit& visit) {
  const Moment after = momentOf(player.world, p);
  for (; !player.over(); ++player.next) {
    const double ticks =
        (player.track.frames[player.next].time - player.origin) * p.controlRate - player.tick;
    if (ticks > 1) return;
    visit(number, player.next, between(player.before, after, float(std::max(ticks, 0.0))));
  }
}

}  // namespace

void playBack(const level::LevelView& level, const Track& track, const std::vector<Window>& windows,
              double delay, const Visit& visit) {
  const Params& p = level.params;
  std::vector<Player> players;
  for (const Window& w : windows) players.push_back(playerOf(track, w, level));
  std::vector<sim::World*> worlds;
  std::vector<sim::RigidBody*> bodies;
  std::vector<sim::Action> actions;
  std::vector<uint32_t> whose;
  do {
    worlds.clear(), bodies.clear(), actions.clear(), whose.clear();
    for (uint32_t i = 0; i < players.size(); ++i) {
      Player& player = players[i];
      if (player.over()) continue;
      const double now = player.origin + player.tick * double(p.tickSeconds);
      if (player.tick <= 0) hold(player, nearestFrame(track, player.window.first, now), level);
      player.before = momentOf(player.world, p);
      worlds.push_back(&player.world);
      bodies.push_back(player.bodies.data());
      // An input counts for a tick if it is active at the middle of the tick.
      actions.push_back(player.actionAt(now - delay + 0.5 * double(p.tickSeconds)));
      whose.push_back(i);
    }
    sim::advanceAll(level, nullptr, worlds, bodies.data(), actions.data());
    for (const uint32_t i : whose) {
      if (players[i].tick >= 0) meetFrames(players[i], p, i, visit);
      ++players[i].tick;
    }
  } while (!worlds.empty());
}

}  // namespace obby::calibrate
