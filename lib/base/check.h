// Checks of invariants. A failed check is a bug in this program, never bad input. It prints both
// values and aborts. Checks run in builds with OBBY_CHECKS; in others the condition is not
// evaluated. Both arguments are numbers, and may be evaluated twice:
//   OBBY_CHECK_LT(index, count);
#pragma once

#if defined(OBBY_CHECKS)
#include <cstdio>
#include <cstdlib>

namespace obby::internal {
template <class A, class B>
[[noreturn]] void checkFailed(const char* file, int line, const char* text, A a, B b) {
  std::fprintf(stderr, "%s:%d: check failed: %s (%.17g, %.17g)\n", file, line, text, double(a),
               double(b));
  std::abort();
}
}  // namespace obby::internal

#define OBBY_CHECK_OP(a, op, b) \
  ((a)op(b) ? (void)0 : ::obby::internal::checkFailed(__FILE__, __LINE__, #a " " #op " " #b, a, b))
#else
#define OBBY_CHECK_OP(a, op, b) ((void)sizeof((a)op(b)))
#endif

#define OBBY_CHECK_EQ(a, b) OBBY_CHECK_OP(a, ==, b)
#define OBBY_CHECK_LT(a, b) OBBY_CHECK_OP(a, <, b)
#define OBBY_CHECK_LE(a, b) OBBY_CHECK_OP(a, <=, b)
