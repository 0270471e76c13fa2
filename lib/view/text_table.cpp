// The table of queries: columns as wide as their texts, the last one takes what is left, or lines
// of its own.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "io/utf8.h"
#include "view/columns.h"
#include "view/flow.h"
#include "view/text_report.h"

namespace obby::view {
namespace {

constexpr size_t kColumns = 8;
constexpr size_t kLeastReason = 40;  // columns, and as many as the longest reason takes
constexpr size_t kMostNameColumns = 28;
using Row = std::array<std::string, kColumns>;

constexpr Rgb kGreen{95, 214, 162}, kRed{240, 72, 78}, kYellow{230, 200, 90}, kPink{255, 122, 217},
    kGrey{151, 161, 179};

struct VerdictText {
  const char* text;
  Rgb color;
};

VerdictText verdictOf(const QueryEntry& query) {
  if (query.mismatch()) return {"MISMATCH", kPink};
  if (!query.result) return {"no answer", kGrey};
  switch (query.answer().getVerdict()) {
    case schema::Verdict::SOLVED: return {"solved", kGreen};
    case schema::Verdict::UNREACHABLE: return {"unreachable", kRed};
    default: return {"unknown", kYellow};
  }
}

// 1234567 as 1.23M.
std::string shortCount(uint64_t value) {
  if (value < 10000) return std::to_string(value);
  const char* units = "kMGTPE";
  auto number = double(value);
  int unit = -1;
  for (; number >= 999.5 && unit < 5; ++unit) number /= 1000;
  return fmt::format("{:.{}f}{}", number, number < 9.995 ? 2 : number < 99.95 ? 1 : 0, units[unit]);
}

std::string reasonOf(const QueryEntry& query) {
  const std::string reason =
      query.result ? std::string(query.answer().getReason()) : "the stream holds no result";
  for (const PathEntry& path : query.paths) {  // solutions first: the verdict is theirs
    const std::string& mismatch = path.playback.mismatch;
    if (mismatch.empty()) continue;
    if (path.kind == PathKind::solution) return "replay: " + mismatch;
    return reason + (reason.empty() ? "" : " ") + "(an attempt's replay: " + mismatch + ")";
  }
  return reason;
}

Row rowOf(const Report& report, const QueryEntry& query) {
  Row row;
  row[0] = query.id;
  row[1] = verdictOf(query).text;
  row[7] = reasonOf(query);
  if (!query.result) return row;
  const auto result = query.answer();
  if (result.getVerdict() == schema::Verdict::SOLVED) {
    const double rate =
        query.level >= 0 ? report.levels[size_t(query.level)].level->view().params.controlRate : 60;
    if (result.getTiming().getFirstSolution() > 0) {
      row[2] = fmt::format("{:.2f} s", result.getTiming().getFirstSolution());
    }
    row[3] = std::to_string(result.getTicks());
    row[4] = fmt::format("{:.2f} s", result.getTicks() / rate);
    row[5] = std::to_string(result.getJumps());
  }
  if (result.getSteps() > 0) row[6] = shortCount(result.getSteps());
  return row;
}

// Ids that queries of several levels have.
std::set<std::string> sharedIds(const Report& report) {
  std::map<std::string, int> levels;
  std::set<std::string> shared;
  for (const QueryEntry& query : report.queries) {
    const auto [first, fresh] = levels.try_emplace(query.id, query.level);
    if (!fresh && first->second != query.level) shared.insert(query.id);
  }
  return shared;
}

std::vector<Row> rowsOf(const Report& report) {
  const std::set<std::string> shared = sharedIds(report);
  std::vector<Row> rows;
  for (const QueryEntry& query : report.queries) {
    rows.push_back(rowOf(report, query));
    if (query.level < 0 || !shared.contains(query.id)) continue;
    rows.back()[0] += " (" + report.levels[size_t(query.level)].level->name() + ")";
  }
  return rows;
}

std::string pad(const std::string& text, size_t width, bool right) {
  const size_t used = columnCount(text);
  const std::string space(width > used ? width - used : 0, ' ');
  return right ? space + text : text + space;
}

// The text in lines of its own, broken between words: a reason is too long for most terminals.
std::string linesOf(const std::string& text, const TerminalTraits& terminal) {
  const std::string indent = "  ";
  Flow lines(terminal.width, 1, indent);
  std::istringstream words(io::tamed(text, !terminal.utf8));
  for (std::string word; words >> word;) {
    word = fitted(word, terminal.width - indent.size(), !terminal.utf8);
    lines.add(word, columnCount(word));
  }
  return lines.text();
}

}  // namespace

std::string queryTable(const Report& report, const TerminalTraits& terminal) {
  constexpr const char* kHeads[kColumns] = {"query", "verdict", "found in", "ticks",
                                            "play",  "jumps",   "steps",    "reason"};
  std::vector<Row> rows = rowsOf(report);
  std::array<size_t, kColumns> widths;
  size_t used = 0;
  for (size_t c = 0; c < kColumns; ++c) {
    widths[c] = std::string_view(kHeads[c]).size();
    for (Row& row : rows) {
      if (c + 1 < kColumns) row[c] = fitted(row[c], kMostNameColumns, !terminal.utf8);
      widths[c] = std::max(widths[c], columnCount(row[c]));
    }
    if (c + 1 < kColumns) used += widths[c] + 2;
  }
  const bool beside = terminal.width >= used + std::max(kLeastReason, widths.back());
  std::string out;
  const auto line = [&](const Row& row, const QueryEntry* query) {
    std::string text;
    for (size_t c = 0; c + 1 < kColumns; ++c) {
      const std::string cell = pad(row[c], widths[c], c >= 2);
      text += c == 1 && query ? colored(cell, verdictOf(*query).color, terminal) : cell;
      text += "  ";
    }
    if (beside) text += fitted(row.back(), terminal.width - used, !terminal.utf8);
    text.erase(text.find_last_not_of(' ') + 1);
    out += text + "\n";
    if (!beside && query) out += linesOf(row.back(), terminal);
  };
  Row heads;
  std::copy(std::begin(kHeads), std::end(kHeads), heads.begin());
  line(heads, nullptr);
  for (size_t i = 0; i < rows.size(); ++i) line(rows[i], &report.queries[i]);
  return out;
}

}  // namespace obby::view
