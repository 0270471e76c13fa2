// Where each option's value comes from: command line, environment, configuration file, default.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <fstream>

#include "cli/check_value.h"
#include "cli/parse.h"
#include "io/text.h"

namespace obby::cli {
namespace {

using Texts = std::map<std::string, std::vector<std::string>>;

// Options that only make sense when typed.
bool onlyTyped(const OptionRow& row) {
  for (const char* name : {"help", "version", "schema", "completion", "print-config", "config"})
    if (row.name == name) return true;
  return false;
}

const OptionRow* findRow(const std::vector<OptionRow>& rows, const std::string& name) {
  for (const OptionRow& row : rows)
    if (row.name == name) return &row;
  return nullptr;
}

Error configError(const std::string& path, const std::string& name, std::string message,
                  std::string hint = {}) {
  return Error{path, {}, name, std::move(message), std::move(hint)};
}

// Options of the tool in a configuration file; sections of other tools are left alone.
Result<Texts> readConfig(const std::string& path, const ToolSpec& spec,
                         const std::vector<OptionRow>& rows) {
  std::ifstream file(path);
  if (!file) return configError(path, "", "cannot open the configuration file");
  std::vector<CLI::ConfigItem> items;
  try {
    items = CLI::ConfigTOML().from_config(file);
  } catch (const CLI::Error& e) {
    return configError(path, "", std::string("not a configuration file: ") + e.what());
  }
  Texts out;
  for (const CLI::ConfigItem& item : items) {
    if (item.name == "++" || item.name == "--") continue;  // CLI11 marks sections so
    if (!item.parents.empty() && item.parents != std::vector<std::string>{spec.name}) continue;
    const OptionRow* row = findRow(rows, item.name);
    if (!row || onlyTyped(*row))
      return configError(path, item.name, "unknown option",
                         "options of another tool go under a section with its name");
    out[item.name] = item.inputs;
  }
  return out;
}

class Resolver {
 public:
  Resolver(const CommandLine& line, const Texts& config, std::string configPath)
      : line_(line), config_(config), configPath_(std::move(configPath)) {}

  Result<Arguments::Value> value(const OptionRow& row) const {
    Arguments::Value out{row, {}, true};
    if (const auto typed = line_.texts.find(row.name); typed != line_.texts.end())
      return checked(std::move(out), typed->second, Error{"--" + row.name, {}, {}, {}, {}});
    const std::string variable = environmentName(row.name);
    const char* environment = onlyTyped(row) ? nullptr : std::getenv(variable.c_str());
    if (environment && *environment)
      return checked(std::move(out), {environment}, Error{variable, {}, {}, {}, {}});
    if (const auto listed = config_.find(row.name); listed != config_.end())
      return checked(std::move(out), listed->second, Error{configPath_, {}, row.name, {}, {}});
    out.given = false;
    if (!row.defaultText.empty()) out.texts.push_back(row.defaultText);
    return out;
  }

 private:
  static Result<Arguments::Value> checked(Arguments::Value out, std::vector<std::string> texts,
                                          Error place) {
    for (std::string& text : texts) {
      auto wrong = checkValue(out.row, text);
      if (!wrong) continue;
      place.message = *wrong;
      return place;
    }
    out.texts = std::move(texts);
    return out;
  }

  const CommandLine& line_;
  const Texts& config_;
  std::string configPath_;
};

// A text as a TOML string.
std::string tomlText(const OptionRow& row, const std::string& text) {
  const bool bare = row.type == ValueType::flag || row.type == ValueType::integer ||
                    row.type == ValueType::number;
  if (bare) return text;
  if (text.find('\'') == std::string::npos) return "'" + text + "'";
  return '"' + text + '"';
}

}  // namespace

std::string environmentName(const std::string& option) {
  std::string out = "OBBY_";
  for (const char c : option) out += c == '-' ? '_' : char(std::toupper(static_cast<uint8_t>(c)));
  return out;
}

Result<Arguments> resolveArguments(const ToolSpec& spec, const std::vector<OptionRow>& rows,
                                   const CommandLine& line) {
  if (!line.wrong) return line.wrong.error();
  Texts config;
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
      out += fmt::format("{} = {}\n", row.name, tomlText(row, texts[0]));
    } else {
      std::vector<std::string> quoted;
      for (const std::string& text : texts) quoted.push_back(tomlText(row, text));
      out += fmt::format("{} = [{}]\n", row.name, fmt::join(quoted, ", "));
    }
  }
  return out;
}

}  // namespace obby::cli
