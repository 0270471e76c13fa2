// The texts of --help, --version and a bare call on a terminal.
#pragma once

#include <string>
#include <vector>

#include "cli/tool.h"

namespace obby::cli {

struct HelpStyle {
  size_t width = 80;  // columns
  bool all = false;   // true for rare options, details and all examples, too
};

// Returns the width of help on a descriptor: the terminal's, but from 40 to 120 columns, or 80
// without a terminal.
size_t helpWidth(int descriptor);

// Returns "obby-solve 0.1.0 (commit 1a2b3c4d5e, schema 1.3)", without the commit if it is unknown.
std::string versionLine(const ToolSpec& spec);

// Returns name, examples, usage, options by group, and notes. Only examples begin with "  $ " or
// continue a line that ends with a backslash: tests run them.
std::string helpText(const ToolSpec& spec, const std::vector<OptionRow>& rows,
                     const HelpStyle& style);

// Returns the short help for a call without any input.
std::string shortHelp(const ToolSpec& spec, size_t width);

// Returns "[OPTION]... [FILE]...", the words after the tool's name in its usage.
std::string usageWords(const ToolSpec& spec);

// Returns the headings of `rows` in order, with kHelpGroup last.
std::vector<std::string> optionGroups(const std::vector<OptionRow>& rows);

// Describes the other ways to set an option.
extern const char* const kOtherSources;

}  // namespace obby::cli
