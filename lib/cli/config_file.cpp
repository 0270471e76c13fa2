#include "cli/config_file.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "cli/parse.h"
#include "io/read_file.h"
#include "io/text.h"

namespace obby::cli {
namespace {

constexpr const char* kQuotesHint =
    "quote a value that contains spaces or commas; put several values in [brackets]";

struct Item {
  std::string section, name;
  ConfigValue value;
  bool alone = false;  // no `=`
  bool blank = false;  // nothing after the `=`
};

std::string trimmed(std::string_view text) {
  const size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return std::string(text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin));
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(io::withoutByteOrderMark(text)) {}

  // Returns the next option, or nothing at the end.
  Result<std::optional<Item>> next() {
    for (name_.clear();;) {
      skipBlankLines();
      if (atEnd()) return std::optional<Item>();
      if (!accept('[')) break;
      OBBY_RETURN_IF_ERROR(readSection());
    }
    const size_t begin = at_;
    name_ = trimmed(take("=#\n"));
    if (name_.empty()) return unexpected("`name = value`", begin);
    Item item{section_, name_, {fmt::format("{}", line_), {}}};
    item.alone = !accept('=');
    if (!item.alone) skipBlanks();
    item.blank = !item.alone && (peek() == '\n' || peek() == '#');
    if (!item.alone && !item.blank) {
      OBBY_ASSIGN(item.value.texts, values());
    }
    OBBY_RETURN_IF_ERROR(endLine());
    return std::optional(std::move(item));
  }

 private:
  Error wrong(std::string message, std::string hint = {}) const {
    return Error{{}, fmt::format("{}", line_), name_, std::move(message), std::move(hint)};
  }

  // `begin` is the place in this line where the wrong text begins.
  Error unexpected(const char* expected, size_t begin, std::string hint = {}) {
    at_ = begin;
    const std::string found = io::quoted(trimmed(take("\n")));
    return wrong(fmt::format("expected {}, found {}", expected, found), std::move(hint));
  }

  bool atEnd() const { return at_ == text_.size(); }
  char peek() const { return atEnd() ? '\n' : text_[at_]; }

  bool accept(char c) {
    if (atEnd() || peek() != c) return false;
    if (c == '\n') line_++;
    at_++;
    return true;
  }

  // Takes text up to the first of `ends`, which include the end of the line, or to the end of the
  // file.
  std::string_view take(const char* ends) {
    const size_t begin = at_, end = text_.find_first_of(ends, begin);
    at_ = end == std::string_view::npos ? text_.size() : end;
    return text_.substr(begin, at_ - begin);
  }

  void skipBlanks() {
    while (accept(' ') || accept('\t') || accept('\r')) {
    }
  }

  // Skips comments, too.
  void skipBlankLines() {
    do {
      skipBlanks();
      if (peek() == '#') take("\n");
    } while (accept('\n'));
  }

  Status endLine() {
    skipBlanks();
    if (peek() == '#') take("\n");
    if (atEnd() || accept('\n')) return {};
    return unexpected("the end of the line", at_, kQuotesHint);
  }

  // Reads the name of a section, after its `[`.
  Status readSection() {
    const size_t begin = at_ - 1;
    section_ = trimmed(take("]\n"));
    if (section_.empty() || !accept(']'))
      return unexpected("the name of a tool in brackets, such as [obby-solve]", begin);
    return endLine();
  }

  Result<std::vector<std::string>> values() {
    std::vector<std::string> out;
    if (!accept('[')) {
      OBBY_ASSIGN(out.emplace_back(), value(" \t\r\n,"));
      return out;
    }
    for (;;) {
      skipBlankLines();
      if (accept(']')) return out;
      if (atEnd()) return wrong("this bracket is not closed");
      OBBY_ASSIGN(out.emplace_back(), value(" \t\r\n,]"));
      skipBlankLines();
      if (accept(',') || atEnd() || peek() == ']') continue;
      return unexpected("`,` or `]` after a value in brackets", at_);
    }
  }

  // Reads one value. Without quotes it ends at one of `ends`.
  Result<std::string> value(const char* ends) {
    if (accept('\'')) {
      std::string text(take("'\n"));
      if (!accept('\'')) return wrong("this quote is not closed");
      return text;
    }
    if (accept('"')) return escapedText();
    std::string text(take(ends));
    if (text.empty()) return unexpected("a value", at_);
    return text;
  }

  Result<std::string> escapedText() {
    std::string out;
    for (;;) {
      out += take("\"\\\n");
      if (accept('"')) return out;
      if (!accept('\\')) return wrong("this quote is not closed");
      switch (peek()) {
        case '"':
        case '\\': out += peek(); break;
        case 'n': out += '\n'; break;
        case 'r': out += '\r'; break;
        case 't': out += '\t'; break;
        default:
          return wrong("unknown escape sequence",
                       "use 'single quotes' to keep the backslash as it is");
      }
      at_++;
    }
  }

  std::string_view text_;
  size_t at_ = 0;
  uint64_t line_ = 1;
  std::string section_, name_;  // the current place
};

const OptionRow* findRow(const std::vector<OptionRow>& rows, const std::string& name) {
  for (const OptionRow& row : rows)
    if ((row.name == name || row.formerly == name) && !onlyTyped(row)) return &row;
  return nullptr;
}

// Adds a value to those of its section.
Status add(Config& values, Item item, const std::vector<OptionRow>& rows) {
  const auto wrong = [&](std::string message, const char* hint) {
    return Error{{}, item.value.line, item.name, std::move(message), hint};
  };
  const OptionRow* row = findRow(rows, item.name);
  if (!row)
    return wrong("unknown option", "put options of other tools in a section such as [obby-solve]");
  if (item.blank || (item.alone && row->type != ValueType::flag)) {
    const bool text = row->type == ValueType::text;
    return wrong("needs a value", text ? "write '' for empty text, or leave out the line"
                                       : "leave out the line to keep the default");
  }
  if (item.alone) item.value.texts = {"true"};
  ConfigValue& all = values[row->name];
  all.line = item.value.line;
  for (std::string& text : item.value.texts) all.texts.push_back(std::move(text));
  if (!row->repeatable && all.texts.size() != 1)
    return wrong(fmt::format("expected one value, found {}", all.texts.size()), "");
  return {};
}

}  // namespace

Result<Config> readConfig(const std::string& path, const ToolSpec& spec,
                          const std::vector<OptionRow>& rows) {
  const auto inFile = [&](Error error) {
    error.input = path;
    return error;
  };
  OBBY_ASSIGN(const std::string text, io::readFile(path));
  Reader reader(text);
  Config everyTools, own;
  for (;;) {
    auto item = reader.next();
    if (!item) return inFile(item.error());
    if (!*item) break;
    const std::string& section = (*item)->section;
    if (!section.empty() && section != spec.name) continue;
    Config& into = section.empty() ? everyTools : own;
    if (Status added = add(into, **std::move(item), rows); !added) return inFile(added.error());
  }
  own.merge(everyTools);
  return own;
}

std::string configValue(const std::string& text) {
  if (text.find_first_of("'\n") == std::string::npos) return "'" + text + "'";
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c == '\n' ? "\\n" : std::string(1, c);
  }
  return out + '"';
}

}  // namespace obby::cli
