// Writes relaxations into records of the stream.
#pragma once

#include <vector>

#include "schema/obby.capnp.h"
#include "solve/report/relaxation/explain.h"

namespace obby::solve {

// Fills in the relaxations that help. The reason ends with the first, or says that none helps.
void fillRelaxations(schema::Result::Builder record, const std::vector<Relaxation>& found);

}  // namespace obby::solve
