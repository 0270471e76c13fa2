// Parses types and discards them. Accepts types that only the type checker rejects.
#pragma once

#include "engine/luau/ast.h"
#include "engine/luau/token_cursor.h"

namespace obby::luau {

class TypeParser : protected TokenCursor {
 public:
  virtual ~TypeParser() = default;

 protected:
  using TokenCursor::TokenCursor;

  virtual ExprPtr expression(int minBinding = 0) = 0;  // typeof(expression)

  void type();
  void typeAtom();
  void namedType();
  void tableType();
  void functionType();
  void typeOrPack();
  void typeArguments();
  void annotation() {
    if (accept(":")) type();
  }
  void instantiation();
  void generics();  // parses <T, U..., V = default>, if there is a list
};

}  // namespace obby::luau
