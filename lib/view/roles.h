// What a part is to the player, for its colour: one role a part, the gravest first.
#pragma once

#include <cstdint>
#include <vector>

#include "schema/obby.capnp.h"

namespace obby::view {

// In the order of ROLES in web/src/data.js.
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
  ghost,  // not solid, and none of those above
  loose,  // a body that can be pushed
};

// One for each part.
std::vector<Role> rolesOf(schema::Level::Reader level);

}  // namespace obby::view
