// The option table, with one row for each option. Help, manual pages, checks, completions, OBBY_*
// variables, --config and --print-config all use these rows, so an option is described in one place
// only.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace obby::cli {

enum class ValueType {
  flag,     // no value
  text,     // any text
  file,     // a path; shells complete it as a path
  integer,  // a whole number in [min, max]
  number,   // a finite number in [min, max]
  seed,     // 0 to 2^64 - 1
  choice,   // one of `choices`
  mode,  // like choice, but the value is optional and only after "=": --progress, --progress=json
};

struct OptionRow {
  std::string name;      // "time-limit": --time-limit, OBBY_TIME_LIMIT, time-limit = in a file
  std::string formerly;  // an earlier name that works everywhere but is shown nowhere
  char letter = 0;       // 't' for -t; 0 for none
  ValueType type = ValueType::flag;
  std::string value;              // name of the value in help: "SECONDS"
  std::string defaultText;        // as it would be typed; empty for no default
  std::string help;               // one sentence, no full stop
  std::string details;            // more sentences or lines, for --help-all and the manual page
  std::string group = "Options";  // heading in help
  double min = std::numeric_limits<double>::lowest();
  double max = std::numeric_limits<double>::max();
  int64_t multiple = 1;  // integer: the value must be a multiple of this
  std::vector<std::string> choices;
  bool repeatable = false;  // may be given more than once; read by Arguments::list()
  std::string bare;         // mode: the value if none is given
  // file: read completely before anything is written, so that an output may replace it.
  bool renewed = false;
  bool rare = false;    // few users need it: in --help-all and the manual page, not in --help
  bool hidden = false;  // an option for the build, which help and completion omit
};

// Returns true if the value may be a word of its own: `--name VALUE`.
inline bool takesWord(const OptionRow& row) {
  return row.type != ValueType::flag && row.type != ValueType::mode;
}

// Headings in help. kHelpGroup comes last.
inline constexpr const char* kFilesGroup = "Input and output";
inline constexpr const char* kRunGroup = "Threads and random numbers";
inline constexpr const char* kHelpGroup = "Help and messages";

}  // namespace obby::cli
