// The physics parameters of generated levels: the schema's defaults with a recipe's changes.
#pragma once

#include <vector>

#include "base/result.h"
#include "gen/recipe.h"
#include "schema/obby.capnp.h"

namespace obby::gen {

// Both apply a recipe's changes. Errors: an unknown name or a value out of range, with the path
// "physics.NAME".
Status setPhysics(schema::PhysicsParams::Builder to, const std::vector<NamedNumber>& changes);
Result<Params> paramsOf(const std::vector<NamedNumber>& changes);

}  // namespace obby::gen
