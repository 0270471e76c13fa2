#include "sim/body_player.h"
#include "sim/simulator.h"

namespace obby::sim {

namespace {

constexpr float kSettleSeconds = 10;

bool anyAwake(const std::vector<RigidBody>& bodies) {
  for (const RigidBody& b : bodies) {
    if (b.state == RigidBodyState::awake) return true;
  }
  return false;
}

}  // namespace

std::vector<RigidBody> startBodies(const level::LevelView& level) {
  std::vector<RigidBody> bodies = makeBodies(level);
  World world = makeWorld(level, {});
  for (uint32_t left = ticksFromSeconds(level.params, kSettleSeconds); anyAwake(bodies); --left) {
    if (left == 0) return makeBodies(level);
    Candidates none;
    moveTogether(world, bodies.data(), nullptr, {}, level, none);
  }
  return bodies;
}

}  // namespace obby::sim
