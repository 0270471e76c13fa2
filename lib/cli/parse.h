// From argv, the environment and a configuration file to Arguments. parse.cpp alone sees CLI11.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "cli/arguments.h"
#include "cli/tool.h"

namespace obby::cli {

// The tool's rows and the universal ones.
std::vector<OptionRow> allRows(const ToolSpec& spec);

// Options that only make sense when typed: --help, --config and their like.
bool onlyTyped(const OptionRow& row);

// "OBBY_TIME_LIMIT" for "time-limit".
std::string environmentName(const std::string& option);

// What argv says, checked for shape only: no default, no variable, no file.
struct CommandLine {
  std::map<std::string, std::vector<std::string>> texts;
  std::vector<std::string> inputs;
  Status wrong;  // an unknown option, a missing value; --help is honoured all the same

  bool flag(const std::string& name) const {
    const auto found = texts.find(name);
    return found != texts.end() && found->second.back() != "false";
  }
};

CommandLine parseCommandLine(const ToolSpec& spec, const std::vector<OptionRow>& rows, int argc,
                             char** argv);

// Command line over environment over configuration file over defaults, every value checked.
Result<Arguments> resolveArguments(const ToolSpec& spec, const std::vector<OptionRow>& rows,
                                   const CommandLine& line);

// The arguments as a configuration file.
std::string configText(const ToolSpec& spec, const std::vector<OptionRow>& rows,
                       const Arguments& arguments);

}  // namespace obby::cli
