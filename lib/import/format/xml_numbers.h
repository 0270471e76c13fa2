// Parses numbers and booleans from text, as places of all ages write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace obby::importer {

// Accepts INF, -INF, NAN in any case, and the spellings of old Windows libraries (1.#INF, -1.#IND).
// Numbers too large for the type become infinite, too small ones 0. Surrounding white space is
// ignored.
std::optional<float> parseFloat(std::string_view text);
std::optional<double> parseDouble(std::string_view text);
// Also accepts unsigned 64-bit values (as the same bits) and whole numbers written with a fraction.
std::optional<int64_t> parseInt(std::string_view text);
std::optional<bool> parseBool(std::string_view text);

}  // namespace obby::importer
