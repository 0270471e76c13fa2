// What --help, --version and a bare call on a terminal print.
#pragma once

#include <string>
#include <vector>

#include "cli/tool.h"

namespace obby::cli {

struct HelpStyle {
  size_t width = 80;  // columns
  bool all = false;   // rare options, details and all examples, too
};

// The width of help on a file descriptor: that of its terminal from 40 to 120 columns, else 80.
size_t helpWidth(int descriptor);

// "obby-solve 0.1.0 (commit 1a2b3c4d5e, schema 1.3)"; no commit where it is not known.
std::string versionLine(const ToolSpec& spec);

// Name, examples, usage, options by group, notes. Lines that begin with "  $ " are examples and
// nothing else is, with those that follow a backslash at a line's end: tests run them.
std::string helpText(const ToolSpec& spec, const std::vector<OptionRow>& rows,
                     const HelpStyle& style);

// A few lines for those who gave no input.
std::string shortHelp(const ToolSpec& spec, size_t width);

// "[OPTION]... [FILE]...": what follows the tool's name in its usage.
std::string usageWords(const ToolSpec& spec);

// The headings of `rows` in order, that of help and messages last.
std::vector<std::string> optionGroups(const std::vector<OptionRow>& rows);

// How every option can be given but on the command line.
extern const char* const kOtherWays;

}  // namespace obby::cli
