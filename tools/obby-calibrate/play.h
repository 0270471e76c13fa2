// obby-calibrate --play: the simulator's error on recordings that it was not fitted to.
#pragma once

#include <vector>

#include "calibrate/fidelity.h"
#include "cli/context.h"
#include "io/pipeline.h"

namespace obby::tools {

// Writes a metrics record for each recording and one for all, and a summary to stderr. `takes` must
// not be empty. Errors: a level that does not compile with `params`, and those of writing.
Status playTakes(cli::Context& context, io::Pipeline& pipeline,
                 const std::vector<calibrate::Take>& takes, schema::PhysicsParams::Reader params);

}  // namespace obby::tools
