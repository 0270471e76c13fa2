// The programs that jobs run. All paths are absolute.
#pragma once

#include <string>

#include "base/result.h"

namespace obby::bridge {

struct Programs {
  std::string solve;      // obby-solve
  std::string import;     // obby-import; empty: there is none
  std::string calibrate;  // obby-calibrate; empty: there is none
};

// Those beside this program; `solve` instead of the one there if it is not empty. Error: it is not
// a program.
Result<Programs> findPrograms(const std::string& solve);

}  // namespace obby::bridge
