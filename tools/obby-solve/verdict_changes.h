// The verdicts that an edit changed, from one run to the next.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "schema/obby.capnp.h"

namespace obby::tools {

class VerdictChanges {
 public:
  // Adds a verdict of the current run.
  void note(const std::string& level, const std::string& query, schema::Verdict verdict);
  // Discards a run that did not complete.
  void drop() { now_.clear(); }
  // Ends the run. Returns a text such as "query 'stage2' is now unreachable, query 'stage5' is new:
  // solved", or "no verdict changed".
  std::string finish();

 private:
  using Verdicts = std::map<std::pair<std::string, std::string>, schema::Verdict>;

  Verdicts before_, now_;  // verdicts by level and query
};

}  // namespace obby::tools
