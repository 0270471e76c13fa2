#pragma once

#include "calibrate/fit.h"
#include "cli/context.h"
#include "cli/tool.h"

namespace obby::tools {

cli::ToolSpec calibrateSpec();
// Error: options that make no sense together, by name.
Status optionsFit(const cli::Arguments& arguments);
// Is the course written, and nothing fitted?
bool makesTakes(const cli::Arguments& arguments);
calibrate::FitSettings fitSettings(const cli::Context& context);

// Physics parameters with the changes of --set. Errors: no such parameter, no number.
Status applySet(const cli::Arguments& arguments, schema::PhysicsParams::Builder params);

}  // namespace obby::tools
