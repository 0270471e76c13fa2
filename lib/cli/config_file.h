// The file of --config: lines `name = value`, a form of TOML that leaves nothing to be guessed.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/tool.h"

namespace obby::cli {

struct ConfigValue {
  std::string line;  // where it was given, last
  std::vector<std::string> texts;
};
using Config = std::map<std::string, ConfigValue>;  // by the option's name

// What the file gives to the tool's options. A name alone is a flag. A value is one word, 'text as
// it is', "text with \" \\ \n \r \t", or several such in [brackets]. Of the sections only [TOOL]
// is read, and goes over what stands before all sections. Errors: those of the file, with the line.
Result<Config> readConfig(const std::string& path, const ToolSpec& spec,
                          const std::vector<OptionRow>& rows);

// A text as a value of the file.
std::string configValue(const std::string& text);

}  // namespace obby::cli
