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

// Reads the options; lists may have commas. Error: an unknown body or frame rate, with the option
// as path.
Result<AskedPlayers> askedPlayers(const std::vector<std::string>& bodies,
                                  const std::vector<std::string>& frameRates, bool sameKeys);

// Returns the query with the asked players in place of its own. "each" body is each that the level
// admits. If it admits one only, that is the level's physics. If it lists none, every body is
// meant.
io::Record withPlayers(schema::Level::Reader level, const AskedPlayers& asked,
                       const io::Record& query);

}  // namespace obby::solve
