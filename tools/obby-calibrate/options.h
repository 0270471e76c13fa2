#pragma once

#include "calibrate/fit.h"
#include "cli/context.h"
#include "cli/tool.h"

namespace obby::tools {

cli::ToolSpec calibrateSpec();
// Returns an error that names incompatible options.
Status optionsFit(const cli::Arguments& arguments);
// Returns true if the tool writes the course and fits nothing.
bool makesTakes(const cli::Arguments& arguments);
calibrate::FitSettings fitSettings(const cli::Context& context);

// Applies the changes of --set. Errors: an unknown parameter, or not a number.
Status applySet(const cli::Arguments& arguments, schema::PhysicsParams::Builder params);

}  // namespace obby::tools
