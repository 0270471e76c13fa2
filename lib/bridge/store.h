// The bridge's private folder: tokens, levels by the hash of what they came from, answers for warm
// starts. Nothing in it has a name that a client chose.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "bridge/limits.h"
#include "io/sink.h"

namespace obby::bridge {

// A level as it is kept: JSON lines without header and end.
struct StoredLevel {
  std::string levels;                // its level records
  std::vector<std::string> queries;  // a line each
  std::vector<std::string> reports;  // what was said when it was read, a line each
};

class Store {
 public:
  // Makes the folder, for this user only. Error: it cannot be made or written, or belongs to
  // somebody else.
  static Result<Store> open(const std::string& folder, const Limits& limits);

  std::string tokensPath() const { return folder_ + "/tokens"; }

  // The id that those bytes have: the same bytes and version of our tools, the same id.
  static std::string idOf(std::string_view bytes);
  bool has(const std::string& id) const;
  // Keeps the lines of a level, and the reports on it: JSON objects that are no level and no query.
  // The longest unused levels go when there is too much. Error: the disk.
  Status put(const std::string& id, std::string_view lines,
             const std::vector<std::string>& reports) const;
  // Nothing: not here, or no longer.
  Result<std::optional<StoredLevel>> get(const std::string& id) const;

  // Where the answer of a job of this session is kept.
  std::string answerPath(const std::string& session, const std::string& job) const;
  void removeAnswer(const std::string& path) const;

 private:
  std::string levelPath(const std::string& id) const;
  void makeRoom(uint64_t bytes) const;

  std::string folder_;
  uint64_t mostBytes_ = 0;
};

// The `"type"` of a record line that one of our tools wrote; empty: it is none.
std::string_view typeOfLine(std::string_view line);
// The `"id"` of a query line of theirs; empty: it has none.
std::string queryIdOfLine(std::string_view line);

}  // namespace obby::bridge
