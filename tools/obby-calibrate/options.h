#pragma once

#include "calibrate/fit.h"
#include "cli/context.h"
#include "cli/tool.h"

namespace obby::tools {

cli::ToolSpec calibrateSpec();
// Error: incompatible options, by name.
Status optionsFit(const cli::Arguments& arguments);
// True if the course is written and nothing is fitted.
bool makesTakes(const cli::Arguments& arguments);
calibrate::FitSettings fitSettings(const cli::Context& context);

// Applies the changes of --set. Errors: no such parameter, or no number.
Status applySet(const cli::Arguments& arguments, schema::PhysicsParams::Builder params);

}  // namespace obby::tools
