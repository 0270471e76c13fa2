// The plugin's sources as one model file (rbxmx) that Studio loads: the Script `obby` with the text
// of init.server.luau, below it every other file as a ModuleScript, folders as Folders, and the
// modules `version`, with what the build knows, and `courseText`, the calibration course. The same
// sources give the same bytes.
#pragma once

#include <string>

#include "base/result.h"

namespace obby::studio {

// `folder` holds init.server.luau; `course` is the course's stream of records, JSON Lines. Errors
// name the file that cannot be read.
Result<std::string> packagePlugin(const std::string& folder, const std::string& course);

}  // namespace obby::studio
