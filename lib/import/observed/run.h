// Runs a place's scripts and brings the document to the state in which they leave it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/report.h"
#include "import/observed/settled.h"
#include "import/tree.h"

namespace obby::importer {

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

// A document without scripts comes back as it is.
ObservedPlace observePlace(const Document& document);

// "script Trap line 3: hit.Parent.Humanoid.Health = 0"; "a script" where nobody is known.
std::string lineReason(const Tree& tree, engine::Line line);

}  // namespace obby::importer
