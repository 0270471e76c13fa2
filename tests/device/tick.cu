// Proves that the device headers compile for the GPU: a world played there by the same code as on
// the CPU. Built by the preset `cuda` only; nothing launches it until the CUDA backend does.
#include "base/random.h"
#include "sim/rules.h"
#include "sim/tick.h"

namespace obby {

__global__ void playOnDevice(sim::World* worlds, const level::LevelView* level,
                             const level::QueryView* query, uint32_t count, uint32_t ticks) {
  const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i >= count) return;
  Random random(1, i);
  sim::World world = worlds[i];
  for (uint32_t t = 0; t < ticks; ++t) {
    sim::tick(world, nullptr, *level, {Turns(random.next()), true, random.below(8) == 0});
    sim::applyRules(world, *level, *query);
  }
  worlds[i] = world;
}

}  // namespace obby
