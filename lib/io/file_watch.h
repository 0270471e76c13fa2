// Detects changes to files by their size and modification time, which are read on request.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace obby::io {

class FileWatch {
 public:
  // Records the present state of the files. A missing file counts as empty.
  explicit FileWatch(std::vector<std::string> paths);

  // Returns true if a file differs from its recorded state.
  bool changed() const;
  // Records the state of the files again. Waits until they are unchanged for a moment, or until
  // `stop` is set.
  void settle(const std::atomic<bool>& stop);

 private:
  struct State {
    uint64_t bytes;
    int64_t written;  // ticks of the file clock
    bool operator==(const State&) const = default;
  };
  static State stateOf(const std::string& path);

  std::vector<std::string> paths_;
  std::vector<State> states_;
};

}  // namespace obby::io
