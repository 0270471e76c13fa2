// obby-view --live.
#pragma once

#include "cli/context.h"

namespace obby {

// Serves the inputs' report while they come, until it is stopped. What -o names is written when
// they have ended.
Result<cli::ExitCode> runLive(cli::Context& context);

}  // namespace obby
