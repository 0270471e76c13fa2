// The tool's mouth: everything on stderr goes through here, so that messages and the progress line
// do not run into each other. Safe to use from several threads.
#pragma once

#include <mutex>
#include <string>
#include <string_view>

#include "base/result.h"

namespace obby::cli {

// Colours are wanted on that descriptor: a terminal, and neither NO_COLOR nor TERM=dumb.
bool colorsOn(int descriptor);

// Columns of the terminal there; 80 where it is none or does not say.
size_t terminalWidth(int descriptor);

class Console {
 public:
  explicit Console(std::string tool) : tool_(std::move(tool)) {}

  bool jsonErrors = false, quiet = false, verbose = false, color = false;

  // "obby-solve: level.jsonl:12: parts[88].size: expected 3 numbers", or a JSON object.
  void error(const Error& error);
  void warn(const std::string& message);
  void note(const std::string& message);
  // "obby-solve: 3 solved", or a note object; unless quiet.
  void tell(const std::string& message);
  // A line of its own, as it is.
  void line(std::string_view text);
  // A line that the next call overwrites; empty: takes it away. Only for terminals.
  void status(const std::string& text);

 private:
  void message(const char* level, const Error& error);
  void put(std::string_view text);

  std::string tool_;
  std::mutex mutex_;
  bool drawn_ = false;
  bool unheard_ = false;  // its reader takes nothing, and the tool has been told to stop
};

}  // namespace obby::cli
