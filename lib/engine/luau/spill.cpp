// Decides which scopes keep their variables in a table, because a function of Lua 5.1 has fewer
// upvalues and local variables than one of Luau. A scope moves as a whole. Each entry makes a new
// table, so that closures keep their own variables.
#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "engine/luau/scopes.h"

namespace obby::luau {
namespace {

constexpr int kMaxUpvalues = 55;  // 5.1 allows 60; one is the helpers' table
constexpr int kMaxLocals = 160;   // 5.1 allows 200; the emitter needs some

// Moves the scopes with the largest counts until `total` is within the limit.
void moveLargest(std::vector<std::pair<int, Scope*>> counts, int total, int limit) {
  std::stable_sort(counts.begin(), counts.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [count, scope] : counts) {
    if (total <= limit || count < 2) return;
    scope->table = 1;
    total -= count - 1;
  }
}

void limitUpvalues(const FunctionScope& function, const std::deque<Scope>& scopes) {
  if (int(function.upvalues.size()) <= kMaxUpvalues) return;
  std::unordered_map<const Scope*, int> counts;
  for (const Local* local : function.upvalues) ++counts[local->scope];
  int total = 0;
  std::vector<std::pair<int, Scope*>> movable;
  for (const Scope& scope : scopes) {  // script order keeps the result deterministic
    const auto found = counts.find(&scope);
    if (found == counts.end()) continue;
    total += scope.table != 0 ? 1 : found->second;
    if (scope.table == 0) movable.emplace_back(found->second, const_cast<Scope*>(&scope));
  }
  moveLargest(std::move(movable), total, kMaxUpvalues);
}

void limitLocals(const FunctionScope& function) {
  if (function.maxActive <= kMaxLocals) return;
  int total = function.maxActive;
  std::vector<std::pair<int, Scope*>> movable;
  for (Scope* scope : function.scopes) {
    const int count = int(scope->locals.size());
    if (scope->table != 0)
      total -= count - 1;
    else
      movable.emplace_back(count, scope);
  }
  moveLargest(std::move(movable), total, kMaxLocals);
}

}  // namespace

void spill(std::deque<FunctionScope>& functions, std::deque<Scope>& scopes) {
  for (const FunctionScope& function : functions) limitLocals(function);
  for (const FunctionScope& function : functions) limitUpvalues(function, scopes);
  int number = 0;
  for (Scope& scope : scopes)
    if (scope.table != 0) scope.table = ++number;
}

}  // namespace obby::luau
