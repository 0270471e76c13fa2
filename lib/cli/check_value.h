// Checks a text as the value of an option.
#pragma once

#include <optional>
#include <string>

#include "cli/options.h"

namespace obby::cli {

// Returns nothing if `text` is valid, otherwise "expected a whole number from 0 to 16, found
// \"x\"". Changes `text` to the value's normal spelling, such as "true" for "yes".
std::optional<std::string> checkValue(const OptionRow& row, std::string& text);

// Returns the value's name in help, or its choices.
std::string valueLabel(const OptionRow& row);

}  // namespace obby::cli
