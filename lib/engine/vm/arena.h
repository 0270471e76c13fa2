// The memory of one VM: a reserved range of addresses with free lists by size. The addresses are
// the same in every run. The VM hashes tables and functions by address, so the order of a table's
// keys depends on it. The range also limits the VM's memory. Private to lib/engine.
#pragma once

#include <array>
#include <cstddef>

namespace obby::engine {

class Arena {
 public:
  // `capacity` in bytes; untouched memory costs nothing.
  explicit Arena(size_t capacity);
  ~Arena();
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  // Takes the arguments of lua_Alloc. Returns null if the capacity is used up.
  void* resize(void* block, size_t oldSize, size_t newSize);
  bool isMapped() const { return base_ != nullptr; }
  size_t used() const { return used_; }

 private:
  static constexpr size_t kClasses = 140;  // four sizes for each power of two
  struct Free {
    Free* next;
  };

  static size_t classOf(size_t size);
  static size_t sizeOf(size_t sizeClass);
  void* take(size_t sizeClass);
  void give(void* block, size_t sizeClass);

  char* base_ = nullptr;
  size_t capacity_, used_ = 0;
  std::array<Free*, kClasses> free_ = {};
};

}  // namespace obby::engine
