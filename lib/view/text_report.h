// The report for a terminal: a table of queries, and maps seen from above.
#pragma once

#include <string>
#include <vector>

#include "table/answer.h"
#include "table/terminal.h"
#include "view/report.h"

namespace obby::view {

enum class Maps {
  none,
  few,  // maps of the queries in the table, if there are few
  all,
};

struct TextOptions {
  table::TerminalTraits terminal;
  Maps maps = Maps::few;
};

// Returns the report as text, whose lines end in newlines. The text says what is missing.
std::string textReport(const Report& report, const TextOptions& options);

// These functions return the pieces of the report.
std::vector<table::Answer> answersOf(const Report& report);
// Returns a map of one query from above: parts, regions and trajectories. Returns an empty text if
// the query's level is not in the streams.
std::string queryMap(const Report& report, const QueryEntry& query,
                     const table::TerminalTraits& terminal, size_t maxRows = 36);

}  // namespace obby::view
