// The plugin's sources as one model file (rbxmx) that Studio loads: the Script `obby` with the text
// of init.server.luau, below it every other file as a ModuleScript, folders as Folders, and the
// module `version` with what the build knows. The same sources give the same bytes.
#pragma once

#include <string>

#include "base/result.h"

namespace obby::studio {

// `folder` holds init.server.luau. Errors name the file that cannot be read.
Result<std::string> packagePlugin(const std::string& folder);

}  // namespace obby::studio
