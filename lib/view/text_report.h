// The report for a terminal: a table of queries, and maps from above.
#pragma once

#include <string>
#include <vector>

#include "table/answer.h"
#include "table/terminal.h"
#include "view/report.h"

namespace obby::view {

enum class Maps {
  none,
  few,  // of all queries in the table, where these are few
  all,
};

struct TextOptions {
  table::TerminalTraits terminal;
  Maps maps = Maps::few;
};

// Lines end in newlines. Never fails: the text names what is missing.
std::string textReport(const Report& report, const TextOptions& options);

// Its pieces.
std::vector<table::Answer> answersOf(const Report& report);
// The course of one query from above: parts, regions, and its trajectories. Empty where the query's
// level is not in the streams.
std::string queryMap(const Report& report, const QueryEntry& query,
                     const table::TerminalTraits& terminal);

}  // namespace obby::view
