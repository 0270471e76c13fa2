// Orders the pieces and decides which maps to draw.
#include "view/text_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "io/utf8.h"
#include "table/answer_table.h"

namespace obby::view {
namespace {

constexpr size_t kFewMaps = 6;           // max maps without a request
constexpr size_t kTallMaps = 3;          // more maps than these are lower
constexpr size_t kTall = 36, kLow = 18;  // max rows of a map

std::string clean(const std::string& text, const table::TerminalTraits& terminal) {
  return io::tamed(text, !terminal.utf8);
}

std::string levelLines(const Report& report, const table::TerminalTraits& terminal) {
  std::string out = "No queries.\n";
  for (const LevelEntry& level : report.levels) {
    const std::string& name = level.level->name();
    const size_t parts = level.level->partCount();
    out += name.empty() ? "Level without a name" : "Level " + clean(name, terminal);
    out += fmt::format(": {} part{}\n", parts, parts == 1 ? "" : "s");
  }
  return out;
}

// Quotes a text for a shell.
std::string quoted(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '-' || c == '_' || c == '.';
  });
  if (plain) return text;
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string maps(const Report& report, const std::vector<size_t>& rows,
                 const TextOptions& options) {
  if (options.maps == Maps::none) return {};
  if (options.maps == Maps::few && rows.size() > kFewMaps) {
    const std::string id = quoted(clean(report.queries[rows.front()].id, options.terminal));
    return fmt::format("\nFor a map of one query: obby-view --query {} FILE\n", id);
  }
  const size_t height = rows.size() <= kTallMaps ? kTall : kLow;
  std::string out;
  for (const size_t row : rows) {
    const std::string map = queryMap(report, report.queries[row], options.terminal, height);
    if (!map.empty()) out += "\n" + map;
  }
  return out;
}

}  // namespace

std::string textReport(const Report& report, const TextOptions& options) {
  const std::vector<table::Answer> answers = answersOf(report);
  std::string out = answers.empty() ? levelLines(report, options.terminal)
                                    : table::answerTable(answers, options.terminal);
  for (const std::string& note : report.notes) out += clean(note, options.terminal) + "\n";
  return out + maps(report, table::listed(answers), options);
}

}  // namespace obby::view
