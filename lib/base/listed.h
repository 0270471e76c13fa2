// Words as a list in a sentence.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obby {

// "30, 60 or 144", with `last` for "or". Empty for no words.
std::string listed(const std::vector<std::string>& words, std::string_view last);

}  // namespace obby
