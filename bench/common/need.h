// What a bench cannot do without.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "base/result.h"

namespace obby::bench {

// An error ends the bench.
inline void need(const Status& status) {
  if (status) return;
  std::fprintf(stderr, "bench: %s\n", status.error().text().c_str());
  std::exit(1);
}

// What came of it.
template <class T>
T need(Result<T> result) {
  need(result ? Status() : Status(result.error()));
  return *std::move(result);
}

}  // namespace obby::bench
