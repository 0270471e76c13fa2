// The programs that jobs run. All paths are absolute.
#pragma once

#include <string>

#include "base/result.h"

namespace obby::bridge {

struct Programs {
  std::string solve;      // obby-solve
  std::string import;     // obby-import; empty if there is none
  std::string calibrate;  // obby-calibrate; empty if there is none
};

// Returns the programs next to this one. If `solve` is not empty, it is the path of obby-solve.
// Errors: `solve` is not a program, or there is no obby-solve.
Result<Programs> findPrograms(const std::string& solve);

}  // namespace obby::bridge
