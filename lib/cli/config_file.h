// The file of --config: lines of `name = value`, a form of TOML without ambiguities.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/tool.h"

namespace obby::cli {

struct ConfigValue {
  std::string line;  // last line that sets the value
  std::vector<std::string> texts;
};
using Config = std::map<std::string, ConfigValue>;  // keys are the options' names

// Returns the file's values of the tool's options. A name alone is a flag. A value is one word,
// 'literal text', "text with \" \\ \n \r \t", or several of these in [brackets]. Only the section
// [TOOL] is read; it overrides the lines before all sections. Errors have the file and the line.
Result<Config> readConfig(const std::string& path, const ToolSpec& spec,
                          const std::vector<OptionRow>& rows);

// Returns a text in the form of a value of the file.
std::string configValue(const std::string& text);

}  // namespace obby::cli
