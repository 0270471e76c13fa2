// Packs the plugin's sources into one model file (rbxmx) that Studio loads. The Script `obby` has
// the text of init.server.luau. Below it, other files are ModuleScripts and folders are Folders.
// The build adds the modules `version` and `courseText`, the calibration course. The same sources
// result in the same bytes.
#pragma once

#include <string>

#include "base/result.h"

namespace obby::studio {

// `folder` holds init.server.luau; `course` is the course's stream of records, JSON Lines. Returns
// the model file, or an error that names the unreadable file.
Result<std::string> packagePlugin(const std::string& folder, const std::string& course);

}  // namespace obby::studio
