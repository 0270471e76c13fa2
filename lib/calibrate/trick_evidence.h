// Detects which engine tricks were active in the recordings: each recording is played with and
// without every trick.
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
  // Recordings whose mean distance the trick changes by 0.05 studs or more.
  uint32_t nearer = 0, farther = 0;

  // Returns true if most recordings that the trick changes are nearer with it.
  bool isOn() const { return nearer > 2 * farther && with < without; }
};

// Returns one entry for each trick. Errors: those of Level::compile.
Result<std::vector<TrickEvidence>> trickEvidence(std::span<const Take> takes,
                                                 schema::PhysicsParams::Reader params,
                                                 ThreadPool& pool);

// Returns a sentence about the tricks that are on, or an empty text.
std::string textOf(std::span<const TrickEvidence> evidence);

}  // namespace obby::calibrate
