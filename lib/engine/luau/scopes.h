// Resolves each name of a script to a variable, and decides which variables the emitted Lua 5.1
// must keep in a table. A function of 5.1 has 60 upvalues and 200 local variables; one of Luau has
// 200 upvalues.
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
  int index = 0;  // index in its scope
  bool constant = false;
};

// A function, or the chunk.
struct FunctionScope {
  FunctionScope* outer = nullptr;
  std::unordered_set<const Local*> upvalues;
  std::vector<Scope*> scopes;
  int active = 0, maxActive = 0;  // local variables in scope now, and their maximum
};

// A block with its variables. A function's parameters and a loop's variables belong to its body.
struct Scope {
  FunctionScope* function = nullptr;
  std::vector<Local*> locals;
  int table = 0;  // number of the table that holds the variables; 0: local variables
};

class Scopes {
 public:
  // Returns the local variable that a name refers to, or null for a global one.
  const Local* find(const Expr& name) const;
  Scope& of(const Block& block) const { return *byBlock_.at(&block); }
  // Returns a prefix that no variable of the script has.
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

// Resolves all names of a chunk. Fails if a constant is assigned to, or if `continue` skips a
// variable that the condition of its loop needs. The chunk must not be broken and must outlive the
// result.
Result<Scopes> resolve(const Chunk& chunk);

// Gives tables to scopes until every function is within the limits (spill.cpp).
void spill(std::deque<FunctionScope>& functions, std::deque<Scope>& scopes);

// The ways to leave a loop's body early.
struct Leaves {
  bool breaks = false, continues = false;
};
Leaves leavesOf(const Block& body);

}  // namespace obby::luau
