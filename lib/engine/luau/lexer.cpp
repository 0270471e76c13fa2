// Reads the bytes of a source text in one pass.
#include "engine/luau/lexer.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/luau/literals.h"

namespace obby::luau {
namespace {

constexpr std::array<std::string_view, 21> kKeywords = {
    "and",   "break", "do",  "else", "elseif", "end",    "false", "for",  "function", "if",   "in",
    "local", "nil",   "not", "or",   "repeat", "return", "then",  "true", "until",    "while"};
// Symbols, longest first.
constexpr std::array<std::string_view, 17> kLongSymbols = {
    "...", "..=", "//=", "..", "==", "~=", "<=", ">=", "+=",
    "-=",  "*=",  "/=",  "%=", "^=", "::", "->", "//"};

constexpr size_t kLongestName = 1000;  // bytes; the rest is dropped
constexpr const char* kMalformed = "malformed string: its closing quote is missing on this line";
constexpr const char* kEscape = "malformed escape in a string";

bool isNameStart(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isNamePart(char c) { return isNameStart(c) || isDigit(c); }

bool isKeyword(std::string_view text) {
  if (text.size() < 2 || text.size() > 8) return false;
  return std::find(kKeywords.begin(), kKeywords.end(), text) != kKeywords.end();
}

}  // namespace

Lexer::Lexer(std::string_view source) : source_(source) {
  if (source_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // byte order mark
}

void Lexer::read(Token& token) {
  token_ = &token;
  while (token_ && at_ < source_.size()) step();
  if (token_) push(TokenKind::end, "");
}

Token& Lexer::push(TokenKind kind, std::string_view text) {
  Token& token = *std::exchange(token_, nullptr);
  token.kind = kind;
  token.text = text;
  token.number = 0;
  token.line = line_;
  token.opens = false;
  token.error = nullptr;
  return token;
}

void Lexer::advanceTo(size_t end) {
  end = std::min(end, source_.size());
  line_ += int(std::count(source_.begin() + at_, source_.begin() + end, '\n'));
  at_ = end;
}

void Lexer::step() {
  const char c = peek();
  if (c == ' ' || (c >= '\t' && c <= '\r')) return advanceTo(at_ + 1);
  if (c == '-' && peek(1) == '-') return comment();
  if (isNameStart(c)) return word();
  if (isDigit(c) || (c == '.' && isDigit(peek(1)))) return number();
  if (c == '"' || c == '\'') return quoted(c);
  if (c == '`') return section(TokenKind::interpolation);
  if (c == '[' && (peek(1) == '[' || peek(1) == '=') && longString()) return;
  symbol(c);
}

void Lexer::symbol(char c) {
  if (c == '{') braces_.push_back(false);
  if (c == '}' && !braces_.empty()) {
    const bool ofString = braces_.back();
    braces_.pop_back();
    if (ofString) return section(TokenKind::continuation);
  }
  if (!isNameStart(c) && c != '(' && c != ')' && c != ',') {
    for (std::string_view symbol : kLongSymbols) {
      if (source_.substr(at_, symbol.size()) != symbol) continue;
      push(TokenKind::symbol, symbol);
      at_ += symbol.size();
      return;
    }
  }
  push(TokenKind::symbol, source_.substr(at_, 1));
  ++at_;
}

void Lexer::comment() {
  at_ += 2;
  const size_t level = longBracket();
  if (level > 0) {
    const size_t end = longBracketEnd(level);
    if (end == std::string_view::npos)
      push(TokenKind::symbol, "--[").error = "this comment has no end";
    return advanceTo(end);
  }
  advanceTo(source_.find('\n', at_));
}

void Lexer::word() {
  const size_t start = at_;
  while (at_ < source_.size() && isNamePart(source_[at_])) ++at_;
  const std::string_view text = source_.substr(start, std::min(at_ - start, kLongestName));
  push(isKeyword(text) ? TokenKind::keyword : TokenKind::name, text);
}

void Lexer::number() {
  const size_t start = at_;
  while (isDigit(peek()) || peek() == '.' || peek() == '_') ++at_;
  if (peek() == 'e' || peek() == 'E') {
    ++at_;
    if (peek() == '+' || peek() == '-') ++at_;
  }
  while (isNamePart(peek())) ++at_;
  Token& token = push(TokenKind::number, source_.substr(start, at_ - start));
  const auto value = numberValue(token.text);
  token.number = value.value_or(0);
  if (!value) token.error = "malformed number";
}

bool Lexer::text(char quote, char other, Token& token) {
  size_t at = at_;
  const auto ends = [&](char c) { return c == quote || c == other || c == '\n' || c == '\r'; };
  while (at < source_.size() && !ends(source_[at])) {
    if (source_[at] != '\\') {
      token.text += source_[at++];
    } else if (!readEscape(source_, ++at, token.text) && !token.error) {
      token.error = kEscape;
    }
  }
  advanceTo(at);
  return peek() == quote || (other != '\0' && peek() == other);
}

void Lexer::quoted(char quote) {
  Token& token = push(TokenKind::string, "");
  ++at_;
  if (text(quote, quote, token))
    ++at_;
  else if (!token.error)
    token.error = kMalformed;
}

void Lexer::section(TokenKind kind) {
  Token& token = push(kind, "");
  ++at_;
  const bool whole = text('`', '{', token);
  token.opens = whole && peek() == '{';
  if (!whole && !token.error) token.error = kMalformed;
  if (!whole) return;
  if (token.opens && peek(1) == '{') token.error = "'{{' in an interpolated string: write '\\{'";
  if (token.opens) braces_.push_back(true);
  ++at_;
}

size_t Lexer::longBracket() const {
  if (peek() != '[') return 0;
  size_t level = 0;
  while (peek(1 + level) == '=') ++level;
  return peek(1 + level) == '[' ? level + 1 : 0;
}

size_t Lexer::longBracketEnd(size_t level) const {
  const std::string close = "]" + std::string(level - 1, '=') + "]";
  const size_t stop = source_.find(close, at_ + level + 1);
  return stop == std::string_view::npos ? stop : stop + close.size();
}

bool Lexer::longString() {
  const size_t level = longBracket();
  if (level == 0) return false;
  const size_t end = longBracketEnd(level);
  const size_t begin = at_ + level + 1;
  const bool whole = end != std::string_view::npos;
  const size_t stop = whole ? end - level - 1 : source_.size();
  Token& token = push(TokenKind::string, longText(source_.substr(begin, stop - begin)));
  if (!whole) token.error = "this long string has no end";
  advanceTo(end);
  return true;
}

std::vector<Token> tokenize(std::string_view source) {
  Lexer lexer(source);
  std::vector<Token> tokens(1);
  for (lexer.read(tokens[0]); tokens.back().kind != TokenKind::end;)
    lexer.read(tokens.emplace_back());
  return tokens;
}

}  // namespace obby::luau
