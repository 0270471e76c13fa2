// Names parts in sentences for people.
#pragma once

#include <cstdint>
#include <string>

#include "schema/obby.capnp.h"

namespace obby::solve {

// Returns a name like "'Plank'". If other parts share it, returns the end of the path that is
// unique: "'Stage 2/Plank'". If no path is unique, returns "'Plank' (part 12)". A part without a
// name is "part 12".
std::string partText(schema::Level::Reader level, uint32_t part);

}  // namespace obby::solve
