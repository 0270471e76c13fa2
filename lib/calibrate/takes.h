// Recordings with their levels, out of a stream.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "calibrate/objective.h"
#include "io/pipeline.h"

namespace obby::calibrate {

class Takes {
 public:
  // The pipeline's handler: keeps levels and recordings, passes the rest. Errors: a recording
  // whose level did not come before it, those of trackOf() and of Level::compile.
  Result<io::Then> handle(const io::Record& record);

  // In the order in which they came.
  std::vector<Take> take() { return std::move(takes_); }

 private:
  Status add(schema::Recording::Reader recording);

  std::map<std::string, io::Record> levels_;
  std::vector<Take> takes_;
};

// Every n-th, beginning with the n-th, goes to `heldOut`.
std::vector<Take> holdOut(std::vector<Take>& takes, uint32_t n);

}  // namespace obby::calibrate
