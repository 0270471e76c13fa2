// Reads a client's level with obby-import, in a separate process. A hostile file can harm that
// process, but not the bridge.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bridge/limits.h"
#include "bridge/reply.h"
#include "bridge/run.h"

namespace obby::bridge {

struct Imported {
  std::string lines;  // level and query records, with newlines
  size_t levels = 0;
  std::vector<std::string> queries;   // ids of the query records
  std::vector<std::string> warnings;  // JSON of obby-import's reports
  Reply refusal;                      // nothing was read if the status is not 200
};

// `bytes` are a place file, or records in JSON or Cap'n Proto. The content decides which.
kj::Promise<Imported> importLevel(Loop& loop, const std::string& program, std::string bytes,
                                  const Limits& limits);

}  // namespace obby::bridge
