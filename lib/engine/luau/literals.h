// The values of Luau's literals.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace obby::luau {

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

// 12, .5, 1e3, 0xFF, 0b101, with _ anywhere. Nothing: malformed.
std::optional<double> numberValue(std::string_view text);

// `at` is behind a backslash; appends what the escape stands for and moves `at` behind it. False:
// malformed.
bool readEscape(std::string_view source, size_t& at, std::string& value);

// What stands between long brackets: without a first line break; \r\n is \n.
std::string longText(std::string_view inside);

}  // namespace obby::luau
