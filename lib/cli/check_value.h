// Whether a text may be the value of an option.
#pragma once

#include <optional>
#include <string>

#include "cli/options.h"

namespace obby::cli {

// Nothing, or "expected a whole number from 0 to 16, found \"x\"". `text` becomes the value's
// normal spelling: "true" for "yes".
std::optional<std::string> checkValue(const OptionRow& row, std::string& text);

// What help calls the value: its name, or the choices.
std::string valueLabel(const OptionRow& row);

}  // namespace obby::cli
