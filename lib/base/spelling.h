// Case folding of names, and correction of mistyped ones.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obby {

// Returns `text` with ASCII letters in lower case. Other bytes are unchanged.
std::string lower(std::string_view text);

// Returns the name nearest to `text`, or the first of equally near ones. An edit inserts, deletes
// or replaces a byte or swaps two neighbours. Returns "" if no name is within one edit for every
// three bytes of `text` (at least one edit).
std::string nearestName(std::string_view text, const std::vector<std::string>& names);

}  // namespace obby
