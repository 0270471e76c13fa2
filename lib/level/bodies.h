// The named bodies that players come in: one row each. A body decides some of the physics
// parameters, and leaves the others as they are.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "schema/obby.capnp.h"

namespace obby::level {

// A number that the body decides: a field of PhysicsParams.
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
// Null: no row has this name.
const Body* findBody(std::string_view name);
// "r6 or r15", for errors.
std::string bodyNames();

void setBody(const Body& body, schema::PhysicsParams::Builder physics);

}  // namespace obby::level
