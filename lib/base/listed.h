// Joins words into a list for a sentence.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obby {

// Returns "30, 60 or 144" for three words if `last` is "or". Returns "" for no words.
std::string listed(const std::vector<std::string>& words, std::string_view last);

}  // namespace obby
