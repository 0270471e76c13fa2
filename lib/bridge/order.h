// A client's order for a job: the body of POST /v1/jobs, checked, as records and arguments. Only
// numbers and flags of one table reach a command line from here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "bridge/limits.h"

namespace obby::bridge {

enum class Task { solve, calibrate };

struct Order {
  Task task = Task::solve;
  std::string level;                   // id of the level to play, or of the recordings
  std::string warm;                    // id of an earlier job; empty for none
  std::vector<std::string> ask;        // ids of the level's own queries; empty for all of them
  std::vector<std::string> records;    // queries or recordings, in the JSON of lib/io
  std::string physics;                 // params record to play the level under; empty for none
  std::vector<std::string> arguments;  // "--max-steps=1000"
};

// Parses an order. Errors have the path in the body.
Result<Order> parseOrder(std::string_view json, const Limits& limits);

}  // namespace obby::bridge
