// Columns are as wide as their texts; a column without text is left out. The reason fills the rest
// of the line, or its own lines below.
#include "table/answer_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "io/utf8.h"
#include "table/columns.h"
#include "table/flow.h"

namespace obby::table {
namespace {

enum Column { kQuery, kVerdict, kRoute, kPlayTime, kJumps, kFoundIn, kReason, kColumns };

constexpr const char* kHeads[kColumns] = {"query", "verdict",  "from",  "play time",
                                          "jumps", "found in", "reason"};
constexpr size_t kGap = 2;
constexpr size_t kMinReason = 40;  // min columns for reasons in the same line; the longest must fit
constexpr size_t kMaxName = 28;
constexpr size_t kMinPlace = 8, kMaxPlace = 24;  // columns for the start or the goal of a query
using Row = std::array<std::string, kColumns>;
using Widths = std::array<size_t, kColumns>;  // columns; 0 if the column is left out

constexpr Rgb kGreen{95, 214, 162}, kRed{240, 72, 78}, kYellow{230, 200, 90}, kPink{255, 122, 217},
    kGrey{151, 161, 179};

struct VerdictText {
  const char* text;
  Rgb color;
};

VerdictText verdictOf(State state) {
  switch (state) {
    case State::notAsked: return {"not asked in this run", kGrey};
    case State::noResult: return {"no result", kGrey};
    case State::solved: return {"solved", kGreen};
    case State::doubtful: return {"solved, in doubt", kYellow};
    case State::unreachable: return {"unreachable", kRed};
    case State::unknown: return {"unknown", kYellow};
    case State::mismatch: break;
  }
  return {"MISMATCH", kPink};
}

// Returns the ids that queries of several levels share.
std::set<std::string> sharedIds(const std::vector<Answer>& answers) {
  std::map<std::string, std::string> levels;
  std::set<std::string> shared;
  for (const Answer& answer : answers) {
    const auto [first, fresh] = levels.try_emplace(answer.query, answer.level);
    if (!fresh && first->second != answer.level) shared.insert(answer.query);
  }
  return shared;
}

std::string secondsText(const std::optional<double>& seconds) {
  return seconds ? fmt::format("{:.2f} s", *seconds) : "";
}

std::string pad(const std::string& text, size_t width, bool right) {
  const size_t used = columnCount(text);
  const std::string space(width > used ? width - used : 0, ' ');
  return right ? space + text : text + space;
}

class Table {
 public:
  Table(const std::vector<Answer>& answers, const TerminalTraits& terminal)
      : answers_(answers), terminal_(terminal), shared_(sharedIds(answers)) {
    for (const size_t i : listed(answers)) {
      states_.push_back(answers[i].state);
      rows_.push_back(rowOf(answers[i]));
    }
    for (size_t c = 0; c < kRoute; ++c) measure(Column(c));
    for (size_t c = kPlayTime; c < kColumns; ++c) measure(Column(c));
    addRoutes();
  }

  std::string text() const {
    if (rows_.empty()) return {};
    Row heads;
    std::copy(std::begin(kHeads), std::end(kHeads), heads.begin());
    heads[kRoute] += arrow() + "to";
    const bool inColumn = reasonsInColumn();
    std::string out = line(heads, nullptr, inColumn);
    for (size_t i = 0; i < rows_.size(); ++i) {
      out += line(rows_[i], &states_[i], inColumn);
      if (!inColumn) out += linesOf(rows_[i][kReason]);
    }
    const size_t others = answers_.size() - rows_.size();
    if (others == 1) out += "1 other query was not asked in this run.\n";
    if (others > 1) out += fmt::format("{} other queries were not asked in this run.\n", others);
    return out;
  }

 private:
  Row rowOf(const Answer& answer) const {
    Row row;
    row[kQuery] = answer.query;
    if (!answer.level.empty() && shared_.contains(answer.query)) {
      row[kQuery] += " (" + answer.level + ")";
    }
    row[kQuery] = fitted(row[kQuery], kMaxName, !terminal_.utf8);
    row[kVerdict] = verdictOf(answer.state).text;
    row[kPlayTime] = secondsText(answer.playTime);
    if (answer.jumps) row[kJumps] = std::to_string(*answer.jumps);
    row[kFoundIn] = secondsText(answer.foundIn);
    row[kReason] = answer.reason;
    return row;
  }

  void measure(Column c) {
    size_t width = 0;
    for (const Row& row : rows_) width = std::max(width, columnCount(row[c]));
    if (width > 0) width = std::max(width, columnCount(kHeads[c]));
    widths_[c] = width;
  }

  // Adds the routes if the other columns leave enough of the width.
  void addRoutes() {
    const size_t used = usedColumns() + columnCount(arrow());  // no gap after the last column
    const size_t place =
        std::min((terminal_.width - std::min(terminal_.width, used)) / 2, kMaxPlace);
    if (place < kMinPlace) return;
    const std::vector<size_t> indices = listed(answers_);
    for (size_t i = 0; i < rows_.size(); ++i) {
      const Answer& answer = answers_[indices[i]];
      if (!answer.route.empty()) {
        rows_[i][kRoute] = fitted(answer.route, 2 * place + columnCount(arrow()), !terminal_.utf8);
        continue;
      }
      if (answer.from.empty() || answer.to.empty()) continue;
      rows_[i][kRoute] = fitted(answer.from, place, !terminal_.utf8) + arrow() +
                         fitted(answer.to, place, !terminal_.utf8);
    }
    measure(kRoute);
    const size_t head = columnCount(kHeads[kRoute]) + columnCount(arrow()) + 2;
    if (widths_[kRoute] > 0) widths_[kRoute] = std::max(widths_[kRoute], head);
  }

  std::string arrow() const { return terminal_.utf8 ? " → " : " -> "; }

  // Returns the width of all columns but the reason, each with the gap after it.
  size_t usedColumns() const {
    size_t used = 0;
    for (size_t c = 0; c < kReason; ++c) used += widths_[c] > 0 ? widths_[c] + kGap : 0;
    return used;
  }

  bool reasonsInColumn() const {
    if (widths_[kReason] == 0) return false;
    return terminal_.width >= usedColumns() + std::max(kMinReason, widths_[kReason]);
  }

  // `state` is null for the line of headings.
  std::string line(const Row& row, const State* state, bool inColumn) const {
    std::string text;
    for (size_t c = 0; c < kReason; ++c) {
      if (widths_[c] == 0) continue;
      const std::string cell = pad(row[c], widths_[c], c > kRoute);
      text += c == kVerdict && state ? colored(cell, verdictOf(*state).color, terminal_) : cell;
      text += std::string(kGap, ' ');
    }
    if (inColumn) text += fitted(row[kReason], terminal_.width - usedColumns(), !terminal_.utf8);
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  }

  // Returns the text on its own lines, broken between words.
  std::string linesOf(const std::string& text) const {
    if (text.empty()) return {};
    const std::string indent = "  ";
    Flow lines(terminal_.width, 1, indent);
    std::istringstream words(io::tamed(text, !terminal_.utf8));
    for (std::string word; words >> word;) {
      word = fitted(word, terminal_.width - indent.size(), !terminal_.utf8);
      lines.add(word, columnCount(word));
    }
    return lines.text();
  }

  const std::vector<Answer>& answers_;
  const TerminalTraits& terminal_;
  std::set<std::string> shared_;
  std::vector<Row> rows_;
  std::vector<State> states_;  // state of each row
  Widths widths_{};
};

}  // namespace

std::vector<size_t> listed(const std::vector<Answer>& answers) {
  const bool any = std::any_of(answers.begin(), answers.end(), [](const Answer& answer) {
    return answer.state != State::notAsked;
  });
  std::vector<size_t> rows;
  for (size_t i = 0; i < answers.size(); ++i) {
    if (!any || answers[i].state != State::notAsked) rows.push_back(i);
  }
  return rows;
}

std::string answerTable(const std::vector<Answer>& answers, const TerminalTraits& terminal) {
  return Table(answers, terminal).text();
}

}  // namespace obby::table
