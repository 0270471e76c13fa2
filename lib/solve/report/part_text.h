// Parts in sentences for people.
#pragma once

#include <cstdint>
#include <string>

#include "schema/obby.capnp.h"

namespace obby::solve {

// "'Plank'"; where other parts have that name the end of the path that is its own, "'Stage
// 2/Plank'"; where nothing tells them apart "'Plank' (part 12)". A part without a name is "part
// 12".
std::string partText(schema::Level::Reader level, uint32_t part);

}  // namespace obby::solve
