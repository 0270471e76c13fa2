#include "cli/manual.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "cli/check_value.h"
#include "cli/help.h"
#include "cli/roff.h"
#include "cli/wrap.h"
#include "io/version.h"

namespace obby::cli {
namespace {

using roff::bold;
using roff::escaped;
using roff::italic;

constexpr size_t kCommandWidth = 66;  // columns for an example on a terminal of 80

// The tools in the order of a pipeline.
constexpr std::string_view kTools[] = {"obby-import", "obby-solve",     "obby-view",  "obby-gen",
                                       "obby-train",  "obby-calibrate", "obby-bridge"};

std::string section(const char* name) { return fmt::format(".SH {}\n", name); }

// Formats paragraphs, which are separated by a blank line in `text`.
std::string paragraphs(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const size_t end = std::min(text.find("\n\n"), text.size());
    out += ".PP\n" + escaped(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 2, text.size()));
  }
  return out;
}

// `tag` must already be roff.
std::string tagged(const std::string& tag, const std::string& text) {
  return ".TP\n" + tag + "\n" + text;
}

std::string entries(const std::vector<ManualEntry>& list) {
  std::string out;
  for (const ManualEntry& entry : list) out += tagged(bold(entry.name), escaped(entry.text) + "\n");
  return out;
}

std::string optionTag(const OptionRow& row) {
  std::string out = row.letter ? bold(std::string("-") + row.letter) + ", " : "";
  out += bold("--" + row.name);
  const std::string label = valueLabel(row);
  if (row.type == ValueType::mode) return out + "[=" + italic(label) + "]";
  if (!label.empty()) out += " " + italic(label);
  return row.repeatable ? out + "..." : out;
}

// Keeps the line breaks of the details.
std::string optionEntry(const OptionRow& row) {
  std::string text = escaped(sentence(row.help)) + "\n";
  if (row.repeatable) text += "This option may be given more than once.\n";
  if (!row.defaultText.empty()) text += escaped("Default: " + row.defaultText) + ".\n";
  std::string_view details = row.details;
  while (!details.empty()) {
    const size_t end = std::min(details.find('\n'), details.size());
    text += ".br\n" + escaped(details.substr(0, end)) + "\n";
    details.remove_prefix(std::min(end + 1, details.size()));
  }
  return tagged(optionTag(row), text);
}

std::string options(const std::vector<OptionRow>& all) {
  std::vector<OptionRow> rows;
  for (const OptionRow& row : all)
    if (!row.hidden) rows.push_back(row);
  std::string out = section("OPTIONS");
  for (const std::string& group : optionGroups(rows)) {
    out += ".SS " + roff::argument(group) + "\n";
    for (const OptionRow& row : rows)
      if (row.group == group) out += optionEntry(row);
  }
  return out + ".SS " + roff::argument("Variables and config file") + "\n" +
         escaped(kOtherSources) + "\n";
}

std::string examples(const ToolSpec& spec) {
  std::string out = section("EXAMPLES");
  for (const Example& example : spec.examples)
    out += fmt::format(".PP\n{}:\n.PP\n.RS 4\n.nf\n{}\n.fi\n.RE\n", escaped(example.text),
                       escaped(wrappedCommand(example.command, 0, kCommandWidth)));
  return out;
}

std::string exitStatus(const ToolSpec& spec) {
  std::vector<ManualEntry> codes = {
      {"0", "Everything requested was done."},
      {"2", "The command line, an input or an output has an error; stderr says where."},
      {"130", "Interrupted by Ctrl-C (SIGINT). Results finished by then were written."},
      {"143", "Ended by SIGTERM. Results finished by then were written."},
      {"141", "The program that reads standard output closed it early (SIGPIPE)."}};
  codes.insert(codes.begin() + 1, spec.exitCodes.begin(), spec.exitCodes.end());
  std::stable_sort(codes.begin(), codes.end(), [](const ManualEntry& a, const ManualEntry& b) {
    return std::stoi(a.name) < std::stoi(b.name);
  });
  return section("EXIT STATUS") + entries(codes);
}

std::string environment(const ToolSpec& spec) {
  return section("ENVIRONMENT") +
         entries({{"OBBY_NAME",
                   "Sets the option --name: OBBY_QUIET=yes means --quiet. A dash becomes an "
                   "underscore. Options that print something and exit have no variable."},
                  {"NO_COLOR",
                   "If this variable is set and not empty, " + spec.name + " prints no colours."},
                  {"TERM", "If this variable is \"dumb\", no colours are printed."}});
}

std::string seeAlso(const ToolSpec& spec) {
  std::string out = section("SEE ALSO");
  std::string_view comma;
  for (const std::string_view tool : kTools) {
    if (tool == spec.name) continue;
    out += fmt::format("{}{}(1)", comma, bold(tool));
    comma = ",\n";
  }
  return out + "\n.PP\nThe guides are installed in share/doc/obby/docs.\n";
}

}  // namespace

std::string manualPage(const ToolSpec& spec, const std::vector<OptionRow>& rows) {
  std::string title = spec.name;
  for (char& c : title)
    if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
  std::string out = fmt::format(".TH {} 1 \"\" {} {}\n", escaped(title),
                                roff::argument(std::string("obby ") + io::toolVersion()),
                                roff::argument("User commands"));
  out += ".nh\n.ad l\n";  // no hyphenation and no justification
  out += section("NAME") + escaped(spec.name) + " \\- " + escaped(spec.summary) + "\n";
  out += section("SYNOPSIS") + bold(spec.name) + " " + escaped(usageWords(spec)) + "\n";
  out += section("DESCRIPTION");
  if (spec.takesInputs)
    out += paragraphs(fmt::format("FILE: {}; - or no FILE means standard input.", spec.inputHelp));
  out += paragraphs(spec.notes) + paragraphs(spec.details) + options(rows) + examples(spec) +
         exitStatus(spec) + environment(spec);
  if (!spec.files.empty()) out += section("FILES") + entries(spec.files);
  return out + seeAlso(spec);
}

}  // namespace obby::cli
