// The runs that were made, one JSON object a line, appended as each ends: what was done is never
// done again, and what is interrupted goes on from there.
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

// One method once at one query.
struct Run {
  std::string method, file, query, verdict, expected;
  uint64_t seed = 1;
  double cap = 0;        // seconds
  uint64_t content = 0;  // digest of the level and the query
  uint64_t program = 0;  // digest of the program: another one may search otherwise
  int threads = 0;
  std::string machine;  // what kind it was made on (common/machine.h); empty: not noted
  Timing timing;

  // Which run this is, whatever came of it and whoever made it.
  std::string key() const;
};

// Whose runs count as made. 0, none: any.
struct Maker {
  uint64_t program = 0;
  int threads = 0;
  std::optional<std::string> machine = {};
};

// How many of some runs one kind of machine has made.
struct Made {
  std::string machine;
  size_t runs = 0;
};

// One line, with its newline.
std::string runLine(const Run& run);
Result<Run> parseRun(const std::string& line);

class RunLog {
 public:
  // Reads what is there. Lines that are no runs, as a cut-off write leaves them, are counted only.
  static Result<RunLog> open(const std::string& path);

  // The last run of that key; null if there is none.
  const Run* find(const std::string& key, const Maker& maker) const;
  // The kind of machine that has made most of the runs of these keys; of two that have made as many
  // the one whose last run is later.
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
  bool cutOff_ = false;                     // the last line lacks its newline
  size_t unreadable_ = 0;
  std::vector<Run> runs_;
  std::map<std::string, std::vector<size_t>> byKey_;
};

}  // namespace obby::bench
