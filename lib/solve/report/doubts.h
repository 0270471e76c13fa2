// The import's doubts that an answer depends on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "schema/obby.capnp.h"
#include "solve/model/route.h"

namespace obby::solve {

// Indices of the level's parts that may be harder on a player in the game than in the level,
// ascending.
std::vector<uint32_t> doubtfulParts(schema::Level::Reader level);

// Could a loss make the game easier? Then nothing is shown to be unreachable.
bool mayBeEasier(schema::Level::Reader level);

// Those of `parts` that a player stands on or touches until that tick of the course, in the order
// of the first touch.
std::vector<uint32_t> touchedOf(const std::vector<uint32_t>& parts, const level::LevelView& level,
                                const Course& course, uint32_t lastTick = 0xffffffff);

template <class Record>
void fillDoubtful(Record trajectory, const std::vector<uint32_t>& parts) {
  auto list = trajectory.initDoubtful(uint32_t(parts.size()));
  for (uint32_t i = 0; i < parts.size(); ++i) list.set(i, int32_t(parts[i]));
}

// How the search for a solution without doubtful parts has ended.
enum class Avoiding : uint8_t {
  notTried,
  notFound,
  impossible,  // shown by the bound
};

// Fills in `holds` and `doubts` of a solved query and adds a sentence to its reason, if there is
// any doubt. `touched`: of the shortest solution.
void fillDoubts(schema::Result::Builder result, schema::Level::Reader level,
                const std::vector<uint32_t>& touched, Avoiding avoiding);

}  // namespace obby::solve
