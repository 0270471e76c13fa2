#include "sim/loose_player.h"
#include "sim/simulator.h"

namespace obby::sim {

namespace {

constexpr float kSettleSeconds = 10;

bool anyAwake(const std::vector<LooseBody>& loose) {
  for (const LooseBody& b : loose) {
    if (b.state == LooseState::awake) return true;
  }
  return false;
}

}  // namespace

std::vector<LooseBody> startLoose(const level::LevelView& level) {
  std::vector<LooseBody> loose = makeLoose(level);
  World world = makeWorld(level, {});
  for (uint32_t left = ticksFromSeconds(level.params, kSettleSeconds); anyAwake(loose); --left) {
    if (left == 0) return makeLoose(level);
    Candidates none;
    moveTogether(world, loose.data(), nullptr, {}, level, none);
  }
  return loose;
}

}  // namespace obby::sim
