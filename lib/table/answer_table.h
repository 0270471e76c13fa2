// The table of answers for a terminal: a row for each query.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "table/answer.h"
#include "table/terminal.h"

namespace obby::table {

// Returns the indices of the answers that get a row. If the stream answers or tries any query, only
// those queries get a row; otherwise all do.
std::vector<size_t> listed(const std::vector<Answer>& answers);

// Returns the table. Each line ends in a newline, and the last line counts the queries without a
// row. Returns an empty text for no answers.
std::string answerTable(const std::vector<Answer>& answers, const TerminalTraits& terminal);

}  // namespace obby::table
