// A place after its scripts ran: the document as they leave it, and what was seen.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/report.h"
#include "import/tree.h"

namespace obby::importer {

// What scripts had made of a part of the file when play began.
struct Settled {
  InstanceId id = kNoInstance;
  std::string path;  // in the file
  std::string what;  // "not solid"; empty: the part is gone
  engine::Line line;
};

struct ObservedPlace {
  Document document;      // with the parts that scripts made, and all that they changed for good
  engine::Report report;  // its ids are the document's; what scripts made later has others
  bool ran = false;       // there were scripts, and they ran
  std::vector<Settled> settled = {};
  std::set<InstanceId> brought = {};  // not in the world until a touch or use brings it
  size_t fromFile = 0;  // instances of the document that its file has; those that follow were made
  // The place as it runs with other random numbers; empty if its scripts draw none.
  std::vector<ObservedPlace> others = {};
};

// "script Trap line 3: hit.Parent.Humanoid.Health = 0"; "a script" where nobody is known.
std::string lineReason(const Tree& tree, engine::Line line);

}  // namespace obby::importer
