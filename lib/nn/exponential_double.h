// math/exponential.h in double precision, by libm. Tests use it to compare the gradients of
// templates with finite differences. Host only; no result of a program depends on it.
#pragma once

#include "math/exponential.h"

namespace obby {

inline double expNegative(double x) { return __builtin_exp(x); }
inline double expOf(double x) { return __builtin_exp(x); }
inline double logOf(double x) { return __builtin_log(x); }

}  // namespace obby
