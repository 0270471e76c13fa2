// The table of answers for a terminal: a row for each query.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "table/answer.h"
#include "table/terminal.h"

namespace obby::table {

// Indices of the answers that get a row: all of them, or where any was asked, those that were.
std::vector<size_t> listed(const std::vector<Answer>& answers);

// Lines end in newlines; the last one counts the queries without a row. Empty: no answers.
std::string answerTable(const std::vector<Answer>& answers, const TerminalTraits& terminal);

}  // namespace obby::table
