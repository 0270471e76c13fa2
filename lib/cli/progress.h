// Progress on stderr while a tool works: one line that is redrawn on a terminal, a line every ten
// seconds, or JSON for programs.
#pragma once

#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/stopwatch.h"

namespace obby::cli {

class Console;

struct ProgressState {
  std::string task;                                     // "query stage3"
  double fraction = -1;                                 // 0 to 1; negative if unknown
  std::vector<std::pair<std::string, double>> numbers;  // {"steps", 1.2e9}, {"cells", 4711}
  double secondsLeft = -1;                              // negative if unknown
};

enum class ProgressMode { none, bar, line, json };

// `canDraw` is true if stderr is a terminal on which nothing else is written. "auto" is then bar,
// otherwise none. `quiet` silences all modes except json.
ProgressMode progressMode(const std::string& text, bool canDraw, bool quiet);

// Returns `query stage3  43 %  steps 1.2G  cells 4711  3 h 26 min left`, safe for a terminal and at
// most `width` columns.
std::string progressLine(const ProgressState& state, size_t width);
// Returns one JSON object without newline. The time is its number "seconds left".
std::string progressJson(const ProgressState& state);

class Progress {
 public:
  Progress(ProgressMode mode, Console& console);
  ~Progress();
  // Shows the state if it is due, unless the reader of stderr accepts nothing.
  void update(const ProgressState& state);
  // Removes the line that is drawn, until the next update.
  void hide();

 private:
  ProgressMode mode_;
  Console& console_;
  std::mutex mutex_;
  Stopwatch watch_;
  double last_ = 0;  // seconds at which progress was last shown
  bool shown_ = false;
};

}  // namespace obby::cli
