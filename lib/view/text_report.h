// The report for a terminal: a table of queries, and for each a map from above.
#pragma once

#include <string>

#include "view/report.h"
#include "view/terminal.h"

namespace obby::view {

struct TextOptions {
  TerminalTraits terminal;
  bool maps = true;
};

// Lines end in newlines. Never fails: what is missing is said in the text.
std::string textReport(const Report& report, const TextOptions& options);

// Its pieces.
std::string queryTable(const Report& report, const TerminalTraits& terminal);
// The course of one query from above: parts, regions, and its trajectories. Empty where the query's
// level is not in the streams.
std::string queryMap(const Report& report, const QueryEntry& query, const TerminalTraits& terminal);

}  // namespace obby::view
