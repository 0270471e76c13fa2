// Short functions that make the rows of an option table.
#pragma once

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

// Few users need it, so it is not in --help.
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

}  // namespace obby::cli
