// Notices that files have changed: by their size and time of writing, looked at when asked.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace obby::io {

class FileWatch {
 public:
  // Notes what the files are like now. One that is not there counts as empty.
  explicit FileWatch(std::vector<std::string> paths);

  // Is one of them other than when last noted?
  bool changed() const;
  // Notes them again; waits until nothing has written to them for a moment, or `stop` is set.
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
