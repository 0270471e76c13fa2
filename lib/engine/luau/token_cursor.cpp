// Writes the parser's errors for text that is not Luau.
#include <fmt/format.h>

#include "engine/luau/token_cursor.h"

namespace obby::luau {

bool TokenCursor::Depth::tooDeep() const {
  if (cursor_.depth_ <= kMaxDepth) return false;
  cursor_.fail(cursor_.peek().line, "the code is nested too deeply");
  cursor_.next();
  return true;
}

void TokenCursor::fail(int line, std::string message) {
  if (broken_) return;
  broken_ = true;
  error_ = std::move(message);
  errorLine_ = line;
}

void TokenCursor::failHere(std::string_view expected) {
  if (broken_) return;
  if (peek().error) return fail(peek().line, peek().error);
  fail(peek().line, fmt::format("expected {}, found {}", expected, found()));
}

std::string TokenCursor::found() const {
  switch (peek().kind) {
    case TokenKind::end: return "'<end of file>'";
    case TokenKind::string:
    case TokenKind::interpolation:
    case TokenKind::continuation: return "a string";
    default: break;
  }
  const std::string& text = peek().text;
  const unsigned char first = text.empty() ? 0 : static_cast<unsigned char>(text[0]);
  if (first < ' ' || first > '~') return fmt::format("a byte of value {}", first);
  return fmt::format("'{:.40}'", text);
}

void TokenCursor::expectKeyword(std::string_view keyword) {
  if (!acceptKeyword(keyword)) failHere(fmt::format("'{}'", keyword));
}

void TokenCursor::expect(std::string_view symbol) {
  if (!accept(symbol)) failHere(fmt::format("'{}'", symbol));
}

void TokenCursor::close(std::string_view symbol, std::string_view opener, int line) {
  if (accept(symbol) || broken_) return;
  failHere(fmt::format("'{}' to close '{}' of line {}", symbol, opener, line));
}

void TokenCursor::closeKeyword(std::string_view keyword, std::string_view opener, int line) {
  if (acceptKeyword(keyword) || broken_) return;
  failHere(fmt::format("'{}' to close '{}' of line {}", keyword, opener, line));
}

std::string TokenCursor::nameToken() {
  if (peek().kind == TokenKind::name) return next().text;
  failHere("a name");
  return {};
}

}  // namespace obby::luau
