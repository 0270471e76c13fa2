// Reading what a client placed by obby-import, in a process of its own: a hostile file costs that
// process, not the bridge.
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
  std::vector<std::string> queries;   // their ids
  std::vector<std::string> warnings;  // JSON of obby-import's reports
  Reply refusal;                      // where status is not 200: nothing was read
};

// `bytes` are a place file or records in JSON or Cap'n Proto: told by content, as ever.
kj::Promise<Imported> importLevel(Loop& loop, const std::string& program, std::string bytes,
                                  const Limits& limits);

}  // namespace obby::bridge
