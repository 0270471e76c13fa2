// Finds misspelt variables, such as OBBY_TIME_LIMT, which set no option.
#pragma once

#include <string>
#include <vector>

#include "cli/options.h"

namespace obby::cli {

struct MisspeltVariable {
  std::string name, meant;  // "OBBY_TIME_LIMT", "OBBY_TIME_LIMIT"
};

// Returns the variables of `environment` that resemble an option of `rows` and set no option of any
// tool. A variable may be meant for another tool of a pipeline. `environment` has the form of
// environ.
std::vector<MisspeltVariable> misspeltVariables(const std::vector<OptionRow>& rows,
                                                const char* const* environment);

}  // namespace obby::cli
