// Runs the scripts of a place and reports what they do.
#pragma once

#include "engine/report.h"

namespace obby::engine {

// Runs the place's scripts in a child process without files or network. Same document and plan,
// same report, but for what the time limit cuts.
Report observe(const Document& document, const Plan& plan);

}  // namespace obby::engine
