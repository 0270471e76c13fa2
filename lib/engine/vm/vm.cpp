#include "engine/vm/vm.h"

#include "base/check.h"

namespace obby::engine {
namespace {

constexpr int kBetweenCounts = 1000;  // instructions between counts
constexpr int kRunBody = -1;          // key in the registry

}  // namespace

Vm::Vm(const Budget& budget, void* owner)
    : budget_(budget),
      arena_(budget.memory),
      owner_(owner),
      left_(budget.instructions),
      stretchLeft_(budget.stretch) {
  state_ = arena_.isMapped() ? lua_newstate(allocate, this) : nullptr;
  OBBY_CHECK_EQ(state_ != nullptr, true);
  // Created once, since a call may have no memory left to create it.
  lua_pushcfunction(state_, runBody);
  lua_rawseti(state_, LUA_REGISTRYINDEX, kRunBody);
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

int Vm::runBody(lua_State* L) {
  const Body& body = *static_cast<const Body*>(lua_touserdata(L, 1));
  lua_remove(L, 1);
  return body(L);
}

Result<void> Vm::call(const Body& body, int arguments, int results) {
  const char* const outer = stackBase_;
  if (!outer) stackBase_ = static_cast<const char*>(__builtin_frame_address(0));
  lua_rawgeti(state_, LUA_REGISTRYINDEX, kRunBody);
  lua_insert(state_, -1 - arguments);
  lua_pushlightuserdata(state_, const_cast<Body*>(&body));
  lua_insert(state_, -1 - arguments);
  const int failed = lua_pcall(state_, arguments + 1, results, 0);
  stackBase_ = outer;
  if (failed == 0) return {};
  const bool isText = lua_type(state_, -1) == LUA_TSTRING;
  Error error = makeError(isText ? lua_tostring(state_, -1) : "a script failed");
  lua_pop(state_, 1);
  return error;
}

size_t Vm::stackUsed() const {
  const auto* const here = static_cast<const char*>(__builtin_frame_address(0));
  return stackBase_ && here < stackBase_ ? size_t(stackBase_ - here) : 0;
}

}  // namespace obby::engine
