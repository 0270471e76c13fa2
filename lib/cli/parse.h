// Makes Arguments from argv, the environment and a configuration file. Only parse.cpp uses CLI11.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "cli/arguments.h"
#include "cli/tool.h"

namespace obby::cli {

// Returns the tool's rows and the universal ones.
std::vector<OptionRow> allRows(const ToolSpec& spec);

// Returns true for options that only make sense when typed, such as --help and --config.
bool onlyTyped(const OptionRow& row);

// Returns "OBBY_TIME_LIMIT" for "time-limit".
std::string environmentName(const std::string& option);

// The contents of argv, checked for shape only, without defaults, variables and files.
struct CommandLine {
  std::map<std::string, std::vector<std::string>> texts;
  std::vector<std::string> inputs;
  Status wrong;  // an unknown option or a missing value; --help still works

  bool flag(const std::string& name) const {
    const auto found = texts.find(name);
    return found != texts.end() && found->second.back() != "false";
  }
};

CommandLine parseCommandLine(const ToolSpec& spec, const std::vector<OptionRow>& rows, int argc,
                             char** argv);

// Combines command line, environment, configuration file and defaults, in this order of precedence.
// Every value is checked.
Result<Arguments> resolveArguments(const ToolSpec& spec, const std::vector<OptionRow>& rows,
                                   const CommandLine& line);

// Returns the arguments as a configuration file.
std::string configText(const ToolSpec& spec, const std::vector<OptionRow>& rows,
                       const Arguments& arguments);

}  // namespace obby::cli
