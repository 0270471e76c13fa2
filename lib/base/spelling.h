// Names as people type them: their case, and the name that a mistyped one was meant to be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obby {

// Lower case of ASCII letters; other bytes unchanged.
std::string lower(std::string_view text);

// The name nearest to `text`, of equally near ones the first, if it is near enough to be meant: the
// edits (a byte inserted, deleted or replaced, two neighbours swapped) are at most a third of its
// bytes. Otherwise empty.
std::string nearestName(std::string_view text, const std::vector<std::string>& names);

}  // namespace obby
