// The functions of math/exponential.h in double precision, by libm: for templates whose gradients
// tests hold against finite differences. Host only; nothing that an answer depends on uses them.
#pragma once

#include "math/exponential.h"

namespace obby {

inline double expNegative(double x) { return __builtin_exp(x); }
inline double expOf(double x) { return __builtin_exp(x); }
inline double logOf(double x) { return __builtin_log(x); }

}  // namespace obby
