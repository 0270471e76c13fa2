// The report as text: measures as rows, methods as columns.
#pragma once

#include <string>
#include <vector>

#include "suite/summary.h"

namespace obby::bench {

std::string tableText(const std::vector<std::string>& methods,
                      const std::vector<Measure>& measures);

}  // namespace obby::bench
