// The bridge's private folder: tokens, levels by the hash of their source, and answers for warm
// starts. Clients choose no names in it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "bridge/limits.h"
#include "io/sink.h"

namespace obby::bridge {

// A stored level: JSON lines without header and end.
struct StoredLevel {
  std::string levels;                // level records
  std::vector<std::string> queries;  // a line each
  std::vector<std::string> reports;  // reports from reading the level, one per line
};

class Store {
 public:
  // Makes the folder, for this user only. It is an error if it cannot be made or written, or
  // belongs to another user.
  static Result<Store> open(const std::string& folder, const Limits& limits);

  std::string tokensPath() const { return folder_ + "/tokens"; }

  // Returns the id of these bytes. The same bytes and version of our tools have the same id.
  static std::string idOf(std::string_view bytes);
  bool has(const std::string& id) const;
  // Stores the lines of a level and the reports on it, which are JSON objects that are neither a
  // level nor a query. Drops the least recently used levels beyond the size limit. Errors are the
  // disk's.
  Status put(const std::string& id, std::string_view lines,
             const std::vector<std::string>& reports) const;
  // Returns nothing if the level was never stored, or was dropped.
  Result<std::optional<StoredLevel>> get(const std::string& id) const;

  // Returns the path at which the answer of a job of this session is stored.
  std::string answerPath(const std::string& session, const std::string& job) const;
  void removeAnswer(const std::string& path) const;

 private:
  std::string levelPath(const std::string& id) const;
  void evictFor(uint64_t bytes) const;

  std::string folder_;
  uint64_t maxBytes_ = 0;
};

// Returns the `"type"` of a record line that one of our tools wrote, or "" for any other line.
std::string_view typeOfLine(std::string_view line);
// Returns the `"id"` of a query line of our tools, or "" if it has none.
std::string queryIdOfLine(std::string_view line);

}  // namespace obby::bridge
