// Makes the rows of an option table: short functions, and the rows that tools have in common.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "cli/options.h"

namespace obby::cli {

inline OptionRow row(const char* name, ValueType type, const char* value, std::string defaultText,
                     const char* help, const char* group) {
  OptionRow r;
  r.name = name;
  r.type = type;
  r.value = value;
  r.defaultText = std::move(defaultText);
  r.help = help;
  r.group = group;
  return r;
}

inline OptionRow flagRow(const char* name, const char* help, const char* group) {
  return row(name, ValueType::flag, "", "", help, group);
}

// Sets the choices of a `choice` or `mode`.
inline OptionRow choosing(OptionRow r, std::vector<std::string> choices) {
  r.choices = std::move(choices);
  return r;
}

inline OptionRow repeatable(OptionRow r) {
  r.repeatable = true;
  return r;
}

inline OptionRow between(OptionRow r, double min, double max) {
  r.min = min;
  r.max = max;
  return r;
}

inline OptionRow multipleOf(OptionRow r, int64_t multiple) {
  r.multiple = multiple;
  return r;
}

inline OptionRow renewed(OptionRow r) {
  r.renewed = true;
  return r;
}

// Sets an earlier name of the option, which users may still have in scripts.
inline OptionRow renamed(OptionRow r, const char* formerly) {
  r.formerly = formerly;
  return r;
}

// Marks an option that few users need, so that it is not in --help.
inline OptionRow rare(OptionRow r) {
  r.rare = true;
  return r;
}

// Adds details for --help-all and the manual page.
inline OptionRow detailed(OptionRow r, std::string details) {
  r.details = std::move(details);
  return r;
}

inline OptionRow lettered(OptionRow r, char letter) {
  r.letter = letter;
  return r;
}

// Options that mean the same in every tool.
enum class Common {
  output,     // -o, --output FILE
  format,     // --format jsonl|capnp|packed
  seed,       // --seed N
  threads,    // --threads N; 0 for all that this process may use
  backend,    // --backend auto|cpu|cuda
  timeLimit,  // --time-limit SECONDS
  progress,   // --progress[=auto|line|json|none]
  onError,    // --on-error stop|skip|emit
};

// Returns the row of a common option. Its help or default may change before it is put into a table:
//   options = {commonRow(Common::output), withDefault(commonRow(Common::timeLimit), "10"), ...}
OptionRow commonRow(Common option);
inline OptionRow withDefault(OptionRow r, std::string defaultText) {
  r.defaultText = std::move(defaultText);
  return r;
}

// Returns the rows of all groups in one table.
std::vector<OptionRow> joined(std::initializer_list<std::vector<OptionRow>> groups);

// Returns the rows that every tool has: --help, --help-all, --version, --quiet, --verbose,
// --no-color, --json-errors, --schema, --config, --print-config, --completion, --man. runTool adds
// them.
const std::vector<OptionRow>& universalRows();

}  // namespace obby::cli
