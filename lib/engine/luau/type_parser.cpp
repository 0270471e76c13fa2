// Parses types and discards them. Accepts types that only the type checker rejects.
#include "engine/luau/type_parser.h"

namespace obby::luau {

void TypeParser::type() {
  const Depth depth(*this);
  if (depth.tooDeep()) return;
  if (!accept("|")) accept("&");
  for (;;) {
    typeAtom();
    while (accept("?")) {
    }
    if (!accept("|") && !accept("&")) return;
  }
}

void TypeParser::typeAtom() {
  if (peek().kind == TokenKind::name) return namedType();
  if (peek().kind == TokenKind::string || isKeyword("nil") || isKeyword("true") ||
      isKeyword("false")) {
    next();
    return;
  }
  if (isSymbol("{")) return tableType();
  if (isSymbol("(") || isSymbol("<")) return functionType();
  failHere("a type");
}

void TypeParser::namedType() {
  const int line = peek().line;
  if (next().text == "typeof" && accept("(")) {
    expression();
    return close(")", "(", line);
  }
  while (accept(".")) nameToken();
  if (isSymbol("<")) typeArguments();
}

void TypeParser::tableType() {
  const int line = next().line;
  while (!atEnd() && !isSymbol("}")) {
    const Token& after = peek(1);
    const bool access = isName("read") || isName("write");
    if (access && (after.kind == TokenKind::name || isSymbol(after, "["))) next();
    if (accept("[")) {
      type();
      expect("]");
      expect(":");
    } else if (peek().kind == TokenKind::name && isSymbol(peek(1), ":")) {
      next();
      next();
    }
    type();
    if (!accept(",") && !accept(";")) break;
  }
  close("}", "{", line);
}

// Parses (T), (T, U) as a pack, (name: T, ...U) -> V.
void TypeParser::functionType() {
  generics();
  const int line = peek().line;
  expect("(");
  while (!atEnd() && !isSymbol(")")) {
    if (peek().kind == TokenKind::name && isSymbol(peek(1), ":")) {
      next();
      next();
    }
    typeOrPack();
    if (!accept(",")) break;
  }
  close(")", "(", line);
  if (accept("->")) typeOrPack();
}

// Parses T, T..., ...T, (T, U).
void TypeParser::typeOrPack() {
  if (accept("...")) return type();
  type();
  accept("...");
}

void TypeParser::typeArguments() {
  const int line = next().line;
  if (accept(">")) return;
  do typeOrPack();
  while (accept(","));
  close(">", "<", line);
}

// Parses f<<T, U>>(x).
void TypeParser::instantiation() {
  if (!isSymbol("<")) return;
  const int line = next().line;
  if (!isSymbol("<")) return failHere("'<<' before type arguments");
  typeArguments();
  close(">", "<", line);
}

void TypeParser::generics() {
  if (!isSymbol("<")) return;
  const int line = next().line;
  while (peek().kind == TokenKind::name) {
    next();
    accept("...");
    if (accept("=")) typeOrPack();
    if (!accept(",")) break;
  }
  close(">", "<", line);
}

}  // namespace obby::luau
