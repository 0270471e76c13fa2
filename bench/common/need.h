// Error handling of benches: an error ends the program.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "base/result.h"

namespace obby::bench {

// Exits with the error's message if there is one.
inline void need(const Status& status) {
  if (status) return;
  std::fprintf(stderr, "bench: %s\n", status.error().text().c_str());
  std::exit(1);
}

// Returns the value, or exits with the error's message.
template <class T>
T need(Result<T> result) {
  need(result ? Status() : Status(result.error()));
  return *std::move(result);
}

}  // namespace obby::bench
