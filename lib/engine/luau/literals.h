// Computes the values of Luau's literals.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace obby::luau {

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

// Returns the value of 12, .5, 1e3, 0xFF, 0b101, with _ anywhere, or nullopt if malformed.
std::optional<double> numberValue(std::string_view text);

// Reads an escape; `at` is after its backslash. Appends its value and moves `at` past it. Returns
// false if it is malformed.
bool readEscape(std::string_view source, size_t& at, std::string& value);

// Returns the text between long brackets: without a first line break, and with \n for \r\n.
std::string longText(std::string_view inside);

}  // namespace obby::luau
