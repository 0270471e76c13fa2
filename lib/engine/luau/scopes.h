// Which variable each name of a script means, and which variables the emitted Lua 5.1 must keep in
// a table: a function of 5.1 has 60 upvalues and 200 local variables, one of Luau 200 upvalues.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/result.h"
#include "engine/luau/ast.h"

namespace obby::luau {

struct Scope;

struct Local {
  std::string_view name;
  Scope* scope = nullptr;
  int index = 0;  // in its scope
  bool constant = false;
};

// A function, or the chunk.
struct FunctionScope {
  FunctionScope* outer = nullptr;
  std::unordered_set<const Local*> upvalues;
  std::vector<Scope*> scopes;
  int active = 0, most = 0;  // local variables at a time
};

// A block with its variables; a function's parameters and a loop's variables belong to its body.
struct Scope {
  FunctionScope* function = nullptr;
  std::vector<Local*> locals;
  int table = 0;  // number of the table that holds the variables; 0: they are local variables
};

class Scopes {
 public:
  // Null: a global variable.
  const Local* find(const Expr& name) const;
  Scope& of(const Block& block) const { return *byBlock_.at(&block); }
  // No variable of the script begins with it.
  const std::string& freePrefix() const { return prefix_; }

 private:
  friend class Resolver;

  std::unordered_map<const Expr*, const Local*> byName_;
  std::unordered_map<const Block*, Scope*> byBlock_;
  std::deque<Local> locals_;
  std::deque<Scope> scopes_;
  std::deque<FunctionScope> functions_;
  std::string prefix_;
};

// An error if a constant is assigned to. The chunk is not broken and outlives the answer.
Result<Scopes> resolve(const Chunk& chunk);

// Gives tables to scopes until every function is within the limits (spill.cpp).
void spill(std::deque<FunctionScope>& functions, std::deque<Scope>& scopes);

// What may leave a loop's body early.
struct Leaves {
  bool breaks = false, continues = false;
};
Leaves leavesOf(const Block& body);

}  // namespace obby::luau
