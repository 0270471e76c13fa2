// A report goes where -o says, in the format that was asked for.
#pragma once

#include "cli/context.h"
#include "view/report.h"

namespace obby {

// Error: also a report that holds nothing to show.
Status writeReport(const view::Report& report, cli::Context& context);

}  // namespace obby
