// Runs the scripts of a place and reports what they do.
#pragma once

#include "engine/report.h"

namespace obby::engine {

// Runs the place's scripts in a child process without files or network. Equal documents and plans
// yield equal reports unless the time limit cuts the run.
Report observe(const Document& document, const Plan& plan);

}  // namespace obby::engine
