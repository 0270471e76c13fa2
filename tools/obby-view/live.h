// obby-view --live.
#pragma once

#include "cli/context.h"

namespace obby {

// Serves the inputs' report while they arrive, until stopped. The file of -o is written when they
// have ended.
Result<cli::ExitCode> runLive(cli::Context& context);

}  // namespace obby
