// A place after its scripts ran: the document as they leave it, and the observations.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/report.h"
#include "import/document/tree.h"

namespace obby::importer {

// A change that scripts had made to a part of the file when play began.
struct Settled {
  InstanceId id = kNoInstance;
  std::string path;  // path in the file
  std::string what;  // "not solid"; empty: the part is gone
  engine::Line line;
};

struct ObservedPlace {
  Document document;      // includes parts that scripts made and lasting changes
  engine::Report report;  // its ids are the document's, except for parts that scripts made later
  bool ran = false;       // the place has scripts, and they ran
  std::vector<Settled> settled = {};
  std::set<InstanceId> brought = {};  // parts outside the world until a touch or use brings them
  size_t fromFile = 0;  // number of instances from the file; scripts made all later ones
  // The same place, run with other random numbers; empty if its scripts draw none.
  std::vector<ObservedPlace> others = {};
};

// Returns "script Trap line 3: hit.Parent.Humanoid.Health = 0", or "a script" if the script is
// unknown.
std::string lineReason(const Tree& tree, engine::Line line);

}  // namespace obby::importer
