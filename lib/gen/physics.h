// The physics parameters of generated levels: the schema's defaults with what a recipe changes.
#pragma once

#include <vector>

#include "base/result.h"
#include "gen/recipe.h"
#include "schema/obby.capnp.h"

namespace obby::gen {

// Errors: a name that PhysicsParams does not have, a number outside its range; path "physics.NAME".
Status setPhysics(schema::PhysicsParams::Builder to, const std::vector<NamedNumber>& changes);
Result<Params> paramsOf(const std::vector<NamedNumber>& changes);

}  // namespace obby::gen
