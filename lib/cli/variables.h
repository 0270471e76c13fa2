// Variables that were meant to set an option and set none: OBBY_TIME_LIMT.
#pragma once

#include <string>
#include <vector>

#include "cli/options.h"

namespace obby::cli {

struct MisspeltVariable {
  std::string name, meant;  // "OBBY_TIME_LIMT", "OBBY_TIME_LIMIT"
};

// The variables of `environment` that are near one of `rows`, and the name of no tool's option: a
// variable may be for another tool of a pipeline. `environment` is a list as of environ.
std::vector<MisspeltVariable> misspeltVariables(const std::vector<OptionRow>& rows,
                                                const char* const* environment);

}  // namespace obby::cli
