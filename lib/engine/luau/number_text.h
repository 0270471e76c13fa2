// Prints numbers as Luau does.
#pragma once

#include <string>

namespace obby::luau {

// Returns the shortest decimal that reads back as the value: 0.1, 1000000000000000, 1e+21, 1e-07,
// -0, inf, nan.
std::string numberText(double value);

}  // namespace obby::luau
