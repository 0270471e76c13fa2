// The players that the command line asks for, in place of the query's own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/record.h"

namespace obby::solve {

struct AskedPlayers {
  std::vector<std::string> bodies;      // as in Query.bodies, or "each"
  std::vector<std::string> frameRates;  // numbers, or "each"
  bool sameKeys = false;

  bool empty() const { return bodies.empty() && frameRates.empty() && !sameKeys; }
};

// Reads the options; each string may be a list with commas. Error at the option's path: an unknown
// body or frame rate.
Result<AskedPlayers> askedPlayers(const std::vector<std::string>& bodies,
                                  const std::vector<std::string>& frameRates, bool sameKeys);

// Returns the query with the asked players in place of its own. The body "each" stands for every
// body that the level admits. If the level admits only one, that is the body of its own physics. If
// it lists none, "each" stands for all bodies.
io::Record withPlayers(schema::Level::Reader level, const AskedPlayers& asked,
                       const io::Record& query);

}  // namespace obby::solve
