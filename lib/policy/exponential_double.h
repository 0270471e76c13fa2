// The functions of math/exponential.h in double precision, by libm: for templates whose slopes
// tests hold against finite differences. Host only; nothing that an answer depends on uses them.
#pragma once

#include <cmath>

#include "math/exponential.h"

namespace obby {

inline double expOf(double x) { return std::exp(x); }
inline double logOf(double x) { return std::log(x); }

}  // namespace obby
