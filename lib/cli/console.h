// The tool's output to stderr. All of it goes through here, so that messages and the progress line
// do not mix. Thread-safe.
#pragma once

#include <mutex>
#include <string>
#include <string_view>

#include "base/result.h"

namespace obby::cli {

// Returns true if the descriptor is a terminal, and neither NO_COLOR nor TERM=dumb is set.
bool colorsOn(int descriptor);

// Returns the columns of the terminal; 80 if there is no terminal or its width is unknown.
size_t terminalWidth(int descriptor);

class Console {
 public:
  explicit Console(std::string tool) : tool_(std::move(tool)) {}

  bool jsonErrors = false, quiet = false, verbose = false, color = false;

  // Prints "obby-solve: level.jsonl:12: parts[88].size: expected 3 numbers", or a JSON object.
  void error(const Error& error);
  void warn(const std::string& message);
  void note(const std::string& message);
  // Prints "obby-solve: 3 solved", or a note object. Silent if quiet.
  void tell(const std::string& message);
  // Prints a line unchanged.
  void line(std::string_view text);
  // Shows a line that the next call overwrites; an empty text removes the line. Only for terminals.
  void status(const std::string& text);

 private:
  void message(const char* level, const Error& error);
  void put(std::string_view text);

  std::string tool_;
  std::mutex mutex_;
  bool drawn_ = false;
  bool unheard_ = false;  // the reader accepts nothing, and the tool was asked to stop
};

}  // namespace obby::cli
