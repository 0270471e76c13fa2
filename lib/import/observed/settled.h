// What scripts had made of the file's parts when play began, for the evidence.
#pragma once

#include <string>
#include <vector>

#include "engine/report.h"

namespace obby::importer {

struct Settled {
  InstanceId id = kNoInstance;
  std::string path;  // in the file
  std::string what;  // "not solid"; empty: the part is gone
  engine::Line line;
};

// Parts that differ between the file and the document that `settle` has made of it.
std::vector<Settled> settledIn(const Document& file, const Document& document,
                               const engine::Report& report);

}  // namespace obby::importer
