// What a client asks of a job: the body of POST /v1/jobs, checked, as records and arguments. All
// that reaches a command line from here are numbers and switches of one table.
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
  std::string level;                 // id: to play, or that the recordings were made on
  std::string warm;                  // id of an earlier job; empty: none
  std::vector<std::string> ask;      // ids of the level's own queries; empty: all of them, or
  std::vector<std::string> records;  // queries, or recordings, in the JSON of lib/io
  std::string physics;               // a params record that the level is played under; empty: none
  std::vector<std::string> arguments;  // "--max-steps=1000"
};

// Errors carry the path in the body.
Result<Order> parseOrder(std::string_view json, const Limits& limits);

}  // namespace obby::bridge
