#include "view/picture/world.h"

#include <algorithm>

#include "sim/clocks.h"
#include "sim/rigid_body.h"
#include "sim/simulator.h"
#include "view/roles.h"

namespace obby::view {

namespace {

constexpr float kMinCoverage = 0.12f;  // coverage of a fully transparent part
constexpr float kAwayCoverage = 0.1f;  // as in the page (web/src/scene/level_view.js)

// The colors of the page (web/src/palette.js).
constexpr Rgb kRoleColors[] = {{119, 128, 143}, {53, 196, 141}, {63, 140, 255}, {221, 65, 73},
                               {164, 139, 250}, {230, 200, 90}, {76, 195, 221}, {245, 154, 76},
                               {143, 227, 196}, {91, 100, 114}, {185, 143, 111}};

Surface surfaceOf(schema::Part::Reader part, Role role) {
  const Pattern pattern = role == Role::kill   ? Pattern::stripes
                          : role == Role::goal ? Pattern::checks
                                               : Pattern::plain;
  const auto c = part.getColor();
  const bool own = role == Role::plain || role == Role::ghost;
  return {colorOf(own ? Rgb{c.getR(), c.getG(), c.getB()} : kRoleColors[size_t(role)]), pattern};
}

Solid solidOf(const level::LevelView& level, const level::Collider& c,
              const std::vector<sim::RigidBody>& bodies, uint32_t tick) {
  Pose pose = c.pose;
  if (c.body != level::kNoBody) {
    pose = sim::poseOf(bodies[c.body], level.bodies[c.body]);
  } else if (c.mover != level::kNone) {
    const level::Mover& m = level.movers[c.mover];
    pose = level::moverPose(m, m.trigger == level::kNone ? tick : 0);
  }
  return {pose, c.kind, c.shape};
}

// Returns true if the collider is away at that tick, provided that nothing was touched.
bool absent(const level::LevelView& level, uint32_t collider, uint32_t tick) {
  const uint32_t flags = level.bounds[collider].flags;
  if ((flags & (level::kVanishTimer | level::kClocked)) == 0) return false;
  sim::World untouched{};
  untouched.tick = tick;
  return sim::isAway(untouched, level, level.colliders[collider].role, flags);
}

}  // namespace

World worldOf(const LevelEntry& entry, uint32_t tick) {
  const level::LevelView& level = entry.level->view();
  const auto parts = entry.reader().getParts();
  const std::vector<Role> roles = rolesOf(entry.reader());
  const std::vector<sim::RigidBody> bodies = sim::startBodies(level);
  World out;
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    const level::Collider& c = level.colliders[i];
    Solid solid = solidOf(level, c, bodies, tick);
    const float clear = parts[c.part].getTransparency();
    const bool away = absent(level, i, tick);
    // Invisible walls are hinted at, unlike in the game.
    solid.coverage = away ? kAwayCoverage : clear > 0 ? std::max(1 - clear, kMinCoverage) : 1;
    out.solids.push_back(solid);
    out.surfaces.push_back(surfaceOf(parts[c.part], roles[c.part]));
    out.away.push_back(away);
  }
  return out;
}

}  // namespace obby::view
