// Which verdicts an edit changed: those of one run against those of the run before.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "schema/obby.capnp.h"

namespace obby::tools {

class VerdictChanges {
 public:
  // A verdict of the run at work.
  void note(const std::string& level, const std::string& query, schema::Verdict verdict);
  // Forgets a run that did not get to its end.
  void drop() { now_.clear(); }
  // Ends the run. "query 'stage2' is now unreachable, query 'stage5' is new: solved", or "no
  // verdict changed".
  std::string finish();

 private:
  using Verdicts = std::map<std::pair<std::string, std::string>, schema::Verdict>;

  Verdicts before_, now_;  // by level and query
};

}  // namespace obby::tools
