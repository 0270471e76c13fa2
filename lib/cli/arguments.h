// What the user asked for: the command line, then OBBY_* variables, then the --config file, then
// the defaults of the table. Values were checked against their rows before anyone sees them.
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
  // Input files in order; "-" is standard input. {"-"} when none were given; none once a tool runs
  // that reads none.
  std::vector<std::string> inputs;

  // `name` without dashes. Asking for a name that is not in the table is a mistake in the program.
  // Given by the user, in whatever way; a configuration file that states the default gives nothing.
  bool has(const std::string& name) const;
  bool flag(const std::string& name) const;                // flag
  const std::string& text(const std::string& name) const;  // text, file, choice, mode; may be empty
  int64_t integer(const std::string& name) const;          // integer
  uint64_t seed(const std::string& name = "seed") const;   // seed
  double number(const std::string& name) const;            // number or integer
  const std::vector<std::string>& list(const std::string& name) const;  // repeatable rows
  // Typed on the command line, for this call, and if it is a flag, as on. Environment and
  // configuration file are for many calls, some of which have no use for what they say: an option
  // that would do nothing is refused where it is typed, and passed over where it is set there.
  bool typed(const std::string& name) const;

  // One value as set by runTool and by tests: the table's row and its texts.
  struct Value {
    OptionRow row;
    std::vector<std::string> texts;  // empty: neither given nor a default
    bool given = false, typed = false;
  };
  std::map<std::string, Value> values;

 private:
  const Value& at(const std::string& name) const;
  const std::string& only(const std::string& name) const;
};

// Error: one of `names` is typed, which does nothing beside the other options. Names it, with
// `message` and `cure`.
Status refuseTyped(const Arguments& arguments, std::initializer_list<const char*> names,
                   const std::string& message, const std::string& cure);

}  // namespace obby::cli
