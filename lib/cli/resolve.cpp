// Resolves each option's value, from command line, environment, configuration file or default.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "cli/check_value.h"
#include "cli/config_file.h"
#include "cli/parse.h"

namespace obby::cli {
namespace {

class Resolver {
 public:
  Resolver(const CommandLine& line, const Config& config, std::string configPath)
      : line_(line), config_(config), configPath_(std::move(configPath)) {}

  Result<Arguments::Value> value(const OptionRow& row) const {
    Arguments::Value out{row, {}, true};
    if (const auto typed = line_.texts.find(row.name); typed != line_.texts.end()) {
      out.typed = true;
      return checked(std::move(out), typed->second, Error{{}, {}, "--" + row.name, {}, {}});
    }
    for (const std::string& name : {row.name, row.formerly}) {
      const std::string variable = environmentName(name);
      const bool unused = name.empty() || onlyTyped(row);
      const char* environment = unused ? nullptr : std::getenv(variable.c_str());
      if (environment && *environment)
        return checked(std::move(out), {environment}, Error{{}, {}, variable, {}, {}});
    }
    if (const auto listed = config_.find(row.name);
        listed != config_.end() && !listed->second.texts.empty()) {
      out.given = !statesDefault(row, listed->second.texts);
      return checked(std::move(out), listed->second.texts,
                     Error{configPath_, listed->second.line, row.name, {}, {}});
    }
    out.given = false;
    if (!row.defaultText.empty()) out.texts.push_back(row.defaultText);
    return out;
  }

 private:
  // Returns true for lines that --print-config writes for options that were not set.
  static bool statesDefault(const OptionRow& row, const std::vector<std::string>& texts) {
    return !row.defaultText.empty() && texts.size() == 1 && texts[0] == row.defaultText;
  }

  static Result<Arguments::Value> checked(Arguments::Value out, std::vector<std::string> texts,
                                          Error place) {
    for (std::string& text : texts) {
      auto wrong = checkValue(out.row, text);
      if (!wrong) continue;
      place.message = *wrong;
      return place;
    }
    if (!out.row.repeatable)
      texts.erase(texts.begin(), texts.end() - 1);  // only the last value counts
    out.texts = std::move(texts);
    return out;
  }

  const CommandLine& line_;
  const Config& config_;
  std::string configPath_;
};

std::string configValueOf(const OptionRow& row, const std::string& text) {
  const bool bare = row.type == ValueType::flag || row.type == ValueType::integer ||
                    row.type == ValueType::number;
  return bare ? text : configValue(text);
}

}  // namespace

bool onlyTyped(const OptionRow& row) {
  for (const char* name :
       {"help", "help-all", "man", "version", "schema", "completion", "print-config", "config"})
    if (row.name == name) return true;
  return false;
}

std::string environmentName(const std::string& option) {
  std::string out = "OBBY_";
  for (const char c : option) out += c == '-' ? '_' : char(std::toupper(static_cast<uint8_t>(c)));
  return out;
}

Result<Arguments> resolveArguments(const ToolSpec& spec, const std::vector<OptionRow>& rows,
                                   const CommandLine& line) {
  if (!line.wrong) return line.wrong.error();
  Config config;
  std::string path;
  if (const auto found = line.texts.find("config"); found != line.texts.end()) {
    path = found->second.back();
    OBBY_ASSIGN(config, readConfig(path, spec, rows));
  }
  Arguments out;
  const Resolver resolver(line, config, path);
  for (const OptionRow& row : rows) {
    OBBY_ASSIGN(out.values[row.name], resolver.value(row));
  }
  out.inputs = line.inputs;
  if (out.inputs.empty()) out.inputs.push_back("-");
  if (std::count(out.inputs.begin(), out.inputs.end(), "-") > 1)
    return makeError("- is given twice", "standard input can be read only once");
  return out;
}

std::string configText(const ToolSpec& spec, const std::vector<OptionRow>& rows,
                       const Arguments& arguments) {
  std::string out = fmt::format("# Options of {}\n", spec.name);
  for (const OptionRow& row : rows) {
    if (onlyTyped(row)) continue;
    const auto& texts = arguments.values.at(row.name).texts;
    if (texts.empty() && row.type == ValueType::flag) {
      out += row.name + " = false\n";
    } else if (texts.empty()) {
      out += fmt::format("# {} = {}\n", row.name, valueLabel(row));
    } else if (texts.size() == 1) {
      out += fmt::format("{} = {}\n", row.name, configValueOf(row, texts[0]));
    } else {
      std::vector<std::string> quoted;
      for (const std::string& text : texts) quoted.push_back(configValueOf(row, text));
      out += fmt::format("{} = [{}]\n", row.name, fmt::join(quoted, ", "));
    }
  }
  return out;
}

}  // namespace obby::cli
