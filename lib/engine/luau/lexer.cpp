// One pass over the bytes of a source text.
#include "engine/luau/lexer.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdlib>

namespace obby::luau {
namespace {

constexpr std::array<std::string_view, 22> kKeywords = {
    "and",   "break", "do",  "else", "elseif", "end",    "false", "for",  "function", "if",    "in",
    "local", "nil",   "not", "or",   "repeat", "return", "then",  "true", "until",    "while", ""};
// Longest first.
constexpr std::array<std::string_view, 17> kLongSymbols = {
    "...", "..=", "//=", "..", "==", "~=", "<=", ">=", "+=",
    "-=",  "*=",  "/=",  "%=", "^=", "::", "->", "//"};

constexpr size_t kLongestName = 1000;  // bytes; what comes behind them is left out

bool isNameStart(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool isNamePart(char c) { return isNameStart(c) || std::isdigit(static_cast<unsigned char>(c)); }

class Lexer {
 public:
  explicit Lexer(std::string_view source) : source_(source) {}

  std::vector<Token> run() {
    while (at_ < source_.size()) step();
    push(TokenKind::end, "");
    return std::move(tokens_);
  }

 private:
  char peek(size_t ahead = 0) const {
    return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
  }
  void push(TokenKind kind, std::string text, double number = 0) {
    tokens_.push_back({kind, std::move(text), number, line_});
  }
  void advance() {
    if (source_[at_] == '\n') ++line_;
    ++at_;
  }

  void step() {
    const char c = peek();
    if (c == '-' && peek(1) == '-') return comment();
    if (isNameStart(c)) return word();
    if (std::isdigit(static_cast<unsigned char>(c)) ||
        (c == '.' && std::isdigit(static_cast<unsigned char>(peek(1)))))
      return number();
    if (c == '"' || c == '\'' || c == '`') return quoted(c);
    if (c == '[' && (peek(1) == '[' || peek(1) == '=')) {
      std::string text;
      if (longBracket(&text)) return push(TokenKind::string, std::move(text));
    }
    symbol(c);
  }

  void symbol(char c) {
    for (std::string_view symbol : kLongSymbols) {
      if (source_.substr(at_, symbol.size()) != symbol) continue;
      at_ += symbol.size();
      return push(TokenKind::symbol, std::string(symbol));
    }
    if (std::ispunct(static_cast<unsigned char>(c))) push(TokenKind::symbol, std::string(1, c));
    advance();
  }

  void comment() {
    at_ += 2;
    std::string ignored;
    if (peek() == '[' && longBracket(&ignored)) return;
    while (at_ < source_.size() && source_[at_] != '\n') ++at_;
  }

  void word() {
    const size_t start = at_;
    while (at_ < source_.size() && isNamePart(source_[at_])) ++at_;
    std::string text(source_.substr(start, std::min(at_ - start, kLongestName)));
    const bool keyword = std::find(kKeywords.begin(), kKeywords.end(), text) != kKeywords.end();
    push(keyword ? TokenKind::keyword : TokenKind::name, std::move(text));
  }

  void number() {
    const size_t start = at_;
    const bool hex = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
    while (at_ < source_.size() && (isNamePart(source_[at_]) || source_[at_] == '.' ||
                                    (!hex && (source_[at_] == '-' || source_[at_] == '+') &&
                                     (source_[at_ - 1] == 'e' || source_[at_ - 1] == 'E')))) {
      if (source_[at_] == '.' && peek(1) == '.') break;  // 1..2
      ++at_;
    }
    std::string text(source_.substr(start, at_ - start));
    std::string digits = text;
    std::erase(digits, '_');
    const bool binary = digits[0] == '0' && digits.size() > 2 && (digits[1] | ' ') == 'b';
    push(TokenKind::number, std::move(text),
         binary ? double(std::strtoull(digits.c_str() + 2, nullptr, 2))
                : std::strtod(digits.c_str(), nullptr));
  }

  void quoted(char quote) {
    const int line = line_;
    std::string text;
    advance();
    while (at_ < source_.size() && source_[at_] != quote && (quote == '`' || peek() != '\n')) {
      if (source_[at_] == '\\' && at_ + 1 < source_.size()) advance();
      text += source_[at_];
      advance();
    }
    if (at_ < source_.size() && source_[at_] == quote) advance();
    // An interpolated string with braces has no constant value.
    const bool constant = quote != '`' || text.find('{') == std::string::npos;
    tokens_.push_back(
        {TokenKind::string, constant ? std::move(text) : std::string(), 0, line, constant});
  }

  // [[...]], [=[...]=]; false if it is none, with the position unchanged.
  bool longBracket(std::string* text) {
    size_t level = 0;
    while (peek(1 + level) == '=') ++level;
    if (peek(1 + level) != '[') return false;
    const std::string close = "]" + std::string(level, '=') + "]";
    const size_t begin = at_ + level + 2;
    const size_t stop = std::min(source_.find(close, begin), source_.size());
    *text = source_.substr(begin, stop - begin);
    const size_t next = std::min(stop + close.size(), source_.size());
    while (at_ < next) advance();
    return true;
  }

  std::string_view source_;
  size_t at_ = 0;
  int line_ = 1;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokenize(std::string_view source) { return Lexer(source).run(); }

}  // namespace obby::luau
