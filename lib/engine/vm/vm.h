// A Lua state in an arena, with budgets of instructions: one for each stretch between two yields,
// one for all stretches together. A stretch that exceeds its own budget ends with an error that
// scripts cannot catch. Once the total budget is used up, every stretch ends that way. Private to
// lib/engine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "engine/settings.h"
#include "engine/vm/arena.h"
#include "engine/vm/lua.h"

namespace obby::engine {

class Vm {
 public:
  // ownerOf() returns `owner` to functions that Lua calls.
  Vm(const Budget& budget, void* owner);
  ~Vm();
  Vm(const Vm&) = delete;
  Vm& operator=(const Vm&) = delete;

  lua_State* state() const { return state_; }
  static void* ownerOf(lua_State* L);
  static Vm& of(lua_State* L);

  // Runs `body` with the `arguments` values on top. The body returns how many values it leaves;
  // `results` of them stay on the stack. An error ends the body alone, even one of exhausted
  // memory.
  using Body = std::function<int(lua_State*)>;
  Result<void> call(const Body& body, int arguments = 0, int results = 0);

  // Returns the bytes of the C stack below the outermost call().
  size_t stackUsed() const;

  void beginStretch() { stretchLeft_ = budget_.stretch, timedOut_ = false; }
  bool timedOut() const { return timedOut_; }
  bool isExhausted() const { return left_ == 0; }
  // Returns the rest of the total budget.
  uint64_t left() const { return left_; }
  void limit(uint64_t instructions) { left_ = left_ < instructions ? left_ : instructions; }

 private:
  static void* allocate(void* self, void* block, size_t oldSize, size_t newSize);
  static void count(lua_State* L, lua_Debug* at);
  static int runBody(lua_State* L);

  Budget budget_;
  Arena arena_;
  void* owner_;
  lua_State* state_ = nullptr;
  uint64_t left_, stretchLeft_;
  bool timedOut_ = false;
  const char* stackBase_ = nullptr;
};

}  // namespace obby::engine
