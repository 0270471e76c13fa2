// obby-view --live.
#pragma once

#include "cli/context.h"

namespace obby {

// Serves the report while the inputs arrive, until stopped. The file of -o is written when the
// inputs have ended.
Result<cli::ExitCode> runLive(cli::Context& context);

}  // namespace obby
