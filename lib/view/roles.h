// The role that a part plays for the player, which decides its colour. If several apply, the most
// important one counts.
#pragma once

#include <cstdint>
#include <vector>

#include "schema/obby.capnp.h"

namespace obby::view {

// The order is that of ROLE_STYLE in web/src/palette.js.
enum class Role : uint8_t {
  plain,
  start,
  goal,
  kill,
  moving,
  vanish,
  conveyor,
  pad,
  checkpoint,
  ghost,    // not solid, and none of the above
  dynamic,  // a dynamic body
};

// Returns one role for each part.
std::vector<Role> rolesOf(schema::Level::Reader level);

}  // namespace obby::view
