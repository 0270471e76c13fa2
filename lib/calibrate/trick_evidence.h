// Finds the tricks that the engine of some recordings does: each recording is played with every
// trick and without.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/thread_pool.h"
#include "calibrate/fidelity.h"

namespace obby::calibrate {

struct TrickEvidence {
  schema::Trick trick;
  double without = 0, with = 0;  // mean distance over all recordings, studs
  // Recordings whose mean distance the trick shortens by 0.05 studs or more, or lengthens.
  uint32_t nearer = 0, farther = 0;

  // The engine does this: most recordings that the trick changes are nearer with it.
  bool isOn() const { return nearer > 2 * farther && with < without; }
};

// One for each trick. Errors: those of Level::compile.
Result<std::vector<TrickEvidence>> trickEvidence(std::span<const Take> takes,
                                                 schema::PhysicsParams::Reader params,
                                                 ThreadPool& pool);

// A sentence about the tricks that are on; empty: none is.
std::string textOf(std::span<const TrickEvidence> evidence);

}  // namespace obby::calibrate
