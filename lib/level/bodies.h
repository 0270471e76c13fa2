// The named bodies of players, one row each. A body sets some of the physics parameters and leaves
// the others unchanged.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "schema/obby.capnp.h"

namespace obby::level {

// A field of PhysicsParams and the value that the body sets.
struct BodyNumber {
  const char* field;
  float value;
  const char* source;  // as in the schema: H, M, L, or measured
};

struct Body {
  const char* name;   // "r15"
  const char* title;  // "R15"
  std::span<const BodyNumber> numbers;
};

std::span<const Body> bodies();
// Returns null if no row has this name.
const Body* findBody(std::string_view name);
// Returns the names of all bodies for error messages, such as "r6 or r15".
std::string bodyNames();

void setBody(const Body& body, schema::PhysicsParams::Builder physics);

}  // namespace obby::level
