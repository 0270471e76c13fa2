// The values of a tool's options: from the command line, then OBBY_* variables, then the --config
// file, then the defaults of the table. They are checked against their rows before any code reads
// them.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/options.h"

namespace obby::cli {

class Arguments {
 public:
  // Input files in order; "-" is standard input. Without files it is {"-"}, or empty if the tool
  // reads no inputs.
  std::vector<std::string> inputs;

  // `name` is without dashes. A name that is not in the table is a bug in the program. has() is
  // true if the user set the option in any way; a configuration file that states the default sets
  // nothing.
  bool has(const std::string& name) const;
  bool flag(const std::string& name) const;  // flag
  // For text, file, choice and mode; may be empty.
  const std::string& text(const std::string& name) const;
  int64_t integer(const std::string& name) const;                       // integer
  uint64_t seed(const std::string& name = "seed") const;                // seed
  double number(const std::string& name) const;                         // number or integer
  const std::vector<std::string>& list(const std::string& name) const;  // repeatable rows
  // Returns true if the option was typed on this command line; for a flag, only if it is on. An
  // option without effect is an error if it is typed. It is ignored if the environment or the
  // configuration file sets it, because those serve many calls.
  bool typed(const std::string& name) const;

  // The value of one option, as runTool and tests set it: the table's row and its texts.
  struct Value {
    OptionRow row;
    std::vector<std::string> texts;  // empty if there is neither a value nor a default
    bool given = false, typed = false;
  };
  std::map<std::string, Value> values;

 private:
  const Value& at(const std::string& name) const;
  const std::string& only(const std::string& name) const;
};

// Returns an error if one of `names` is typed, because it has no effect with the other options. The
// error names the option, with `message` and `cure`.
Status refuseTyped(const Arguments& arguments, std::initializer_list<const char*> names,
                   const std::string& message, const std::string& cure);

}  // namespace obby::cli
