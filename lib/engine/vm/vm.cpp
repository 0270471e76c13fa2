#include "engine/vm/vm.h"

#include "base/check.h"

namespace obby::engine {
namespace {

constexpr int kBetweenCounts = 1000;  // instructions

}  // namespace

Vm::Vm(const Budget& budget, void* owner)
    : budget_(budget),
      arena_(budget.memory),
      owner_(owner),
      left_(budget.instructions),
      stretchLeft_(budget.stretch) {
  state_ = arena_.isMapped() ? lua_newstate(allocate, this) : nullptr;
  OBBY_CHECK_EQ(state_ != nullptr, true);
  lua_sethook(state_, count, LUA_MASKCOUNT, kBetweenCounts);
}

Vm::~Vm() { lua_close(state_); }

void* Vm::allocate(void* self, void* block, size_t oldSize, size_t newSize) {
  return static_cast<Vm*>(self)->arena_.resize(block, oldSize, newSize);
}

Vm& Vm::of(lua_State* L) {
  void* self = nullptr;
  lua_getallocf(L, &self);
  return *static_cast<Vm*>(self);
}

void* Vm::ownerOf(lua_State* L) { return of(L).owner_; }

void Vm::count(lua_State* L, lua_Debug*) {
  Vm& vm = of(L);
  vm.left_ -= vm.left_ < kBetweenCounts ? vm.left_ : kBetweenCounts;
  vm.stretchLeft_ -= vm.stretchLeft_ < kBetweenCounts ? vm.stretchLeft_ : kBetweenCounts;
  if (vm.left_ > 0 && vm.stretchLeft_ > 0) return;
  vm.timedOut_ = true;
  luaL_error(L, "Script timeout: exhausted allowed execution time");
}

Result<void> Vm::call(int arguments, int results) {
  if (lua_pcall(state_, arguments, results, 0) == 0) return {};
  const char* const text = lua_tostring(state_, -1);
  Error error = makeError(text ? text : "a script failed");
  lua_pop(state_, 1);
  return error;
}

}  // namespace obby::engine
