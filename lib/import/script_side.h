// On which side of the game a script runs.
#pragma once

#include <cstdint>

#include "import/tree.h"

namespace obby::importer {

// RunContext; 0 leaves it to the class.
constexpr uint32_t kRunServer = 1, kRunClient = 2;

// Whether the player's own client runs the script, and not the server.
bool runsOnClient(const Instance& script);

}  // namespace obby::importer
