// Relaxations as records of the stream.
#pragma once

#include <vector>

#include "schema/obby.capnp.h"
#include "solve/report/relaxation/explain.h"

namespace obby::solve {

// What was found to help, also as the end of the record's reason.
void fillRelaxations(schema::Result::Builder record, const std::vector<Relaxation>& found);

}  // namespace obby::solve
