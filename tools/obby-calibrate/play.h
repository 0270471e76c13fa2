// obby-calibrate --play: how far the simulator is from recordings that it was not fitted to.
#pragma once

#include <vector>

#include "calibrate/fidelity.h"
#include "cli/context.h"
#include "io/pipeline.h"

namespace obby::tools {

// Writes a metrics record for each recording and one for all, and a summary to stderr. `takes`: at
// least one. Errors: a level that cannot be played with `params`, and those of writing.
Status playTakes(cli::Context& context, io::Pipeline& pipeline,
                 const std::vector<calibrate::Take>& takes, schema::PhysicsParams::Reader params);

}  // namespace obby::tools
