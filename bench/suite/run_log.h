// The completed runs, one JSON object per line, appended when each ends. Logged runs are not
// repeated, so an interrupted series can be continued.
#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "suite/statistics.h"

namespace obby::bench {

// One run of a method on a query.
struct Run {
  std::string method, file, query, verdict, expected;
  uint64_t seed = 1;
  double cap = 0;        // seconds
  uint64_t content = 0;  // digest of the level and the query
  uint64_t program = 0;  // digest of the program, since another one may search differently
  int threads = 0;
  std::string machine;  // kind of machine (common/machine.h); empty: unknown
  Timing timing;

  // Identifies the run, whatever its result and maker.
  std::string key() const;
};

// The makers whose runs count; 0 or an absent value accepts any.
struct Maker {
  uint64_t program = 0;
  int threads = 0;
  std::optional<std::string> machine = {};
};

// The number of runs that one kind of machine made.
struct Made {
  std::string machine;
  size_t runs = 0;
};

// Returns one line with its newline.
std::string runLine(const Run& run);
Result<Run> parseRun(const std::string& line);

class RunLog {
 public:
  // Reads the existing runs. Lines that are not runs, such as an incomplete write, are only
  // counted.
  static Result<RunLog> open(const std::string& path);

  // Returns the latest run with the key, or null.
  const Run* find(const std::string& key, const Maker& maker) const;
  // Returns the kind of machine with the most runs of these keys. A tie goes to the one with the
  // latest run.
  Made mostlyBy(const std::vector<std::string>& keys, const Maker& maker) const;
  Status append(const Run& run);
  size_t unreadable() const { return unreadable_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void remember(Run run);

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;  // opened by the first append
  bool cutOff_ = false;                     // the last line has no newline
  size_t unreadable_ = 0;
  std::vector<Run> runs_;
  std::map<std::string, std::vector<size_t>> byKey_;
};

}  // namespace obby::bench
