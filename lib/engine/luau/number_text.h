// Numbers as Luau prints them.
#pragma once

#include <string>

namespace obby::luau {

// The shortest decimal that reads back as the value: 0.1, 1000000000000000, 1e+21, 1e-07, -0, inf,
// nan.
std::string numberText(double value);

}  // namespace obby::luau
