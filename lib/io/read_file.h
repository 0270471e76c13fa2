// A whole file in memory, for inputs that are no streams of records.
#pragma once

#include <string>

#include "base/result.h"

namespace obby::io {

// `path` "-" is standard input. Errors name the file and the reason.
Result<std::string> readFile(const std::string& path);

}  // namespace obby::io
