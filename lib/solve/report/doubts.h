// Finds the import's doubts that an answer depends on, and reports them in the result.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "schema/obby.capnp.h"
#include "solve/model/route.h"

namespace obby::solve {

// Returns the indices, ascending, of the parts that may be harder on a player in the game than in
// the level.
std::vector<uint32_t> doubtfulParts(schema::Level::Reader level);

// Returns true if a loss could make the game easier. Then nothing can be proved unreachable.
bool mayBeEasier(schema::Level::Reader level);

// Returns those of `parts` that the player stands on or touches up to `lastTick`, in the order of
// the first touch.
std::vector<uint32_t> touchedOf(const std::vector<uint32_t>& parts, const level::LevelView& level,
                                const Course& course, uint32_t lastTick = 0xffffffff);

template <class Record>
void fillDoubtful(Record trajectory, const std::vector<uint32_t>& parts) {
  auto list = trajectory.initDoubtful(uint32_t(parts.size()));
  for (uint32_t i = 0; i < parts.size(); ++i) list.set(i, int32_t(parts[i]));
}

// Outcome of the search for a solution without doubtful parts.
enum class Avoiding : uint8_t {
  notTried,
  notFound,
  impossible,  // proved by the bound on reach
};

// Fills in `holds` and `doubts` of a solved query and adds a sentence to its reason, if there is
// any doubt. `touched`: doubtful parts that the first solution touches.
void fillDoubts(schema::Result::Builder result, schema::Level::Reader level,
                const std::vector<uint32_t>& touched, Avoiding avoiding);

}  // namespace obby::solve
