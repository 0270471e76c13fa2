// A handler or thread that has been begun, until it is followed.
#pragma once

#include <string>
#include <vector>

#include "engine/document.h"
#include "import/luau/datum.h"
#include "import/luau/variables.h"
#include "import/script_reading.h"

namespace obby::importer::luau {

struct Pending {
  Trigger trigger = Trigger::start;
  InstanceId touched = kNoInstance;
  std::string signal;
  int line = 0;
  Closure closure;
  std::vector<Datum> arguments;
  double time = 0;
  // As the reader's, where it was begun; `unsure`: in a branch, or behind one, that may be taken.
  bool unsure = false, left = false, vague = false;
  bool triggered = false;  // done each frame, but from a touch or click on
  bool awaited = false;    // begun after what the timeline awaits
  int connection = 0;      // by which number the script can end it; 0: by none
  bool once = false;       // ends as it comes
  bool ofHandler = false;  // done each frame, but from another signal on
  Variables::Found found;  // what the handler that connects it has set
};

}  // namespace obby::importer::luau
