// Copies a struct of tables, and the tables that those point to, into one block of bytes for a
// chosen address. A level is copied to the memory of a GPU in one piece this way. Structs name
// their tables in a forTables() next to their definition (level/level_view.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace obby {

class Flattener {
 public:
  // `base` is the address at which the bytes will be placed.
  explicit Flattener(uintptr_t base) : base_(base) {}

  // Appends a table unless it was appended before, and points `table` to its future address. An
  // empty table becomes null.
  template <class T>
  void operator()(const T*& table, size_t count) {
    if (table == nullptr || count == 0) {
      table = nullptr;
      return;
    }
    const auto [known, isNew] = offsets_.try_emplace({table, count * sizeof(T)}, 0);
    if (isNew) known->second = append(table, count);
    const uintptr_t address = base_ + known->second;
    table = reinterpret_cast<const T*>(address);  // NOLINT(performance-no-int-to-ptr)
  }

  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  // Alignment of the tables, bytes. Each starts on its own cache line of a GPU.
  static constexpr size_t kAlignment = 128;

  template <class T>
  size_t append(const T* table, size_t count) {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= kAlignment);
    std::vector<T> copy(table, table + count);
    if constexpr (requires(T & element, Flattener & f) { forTables(element, f); }) {
      for (T& element : copy) forTables(element, *this);
    }
    const size_t at = (bytes_.size() + kAlignment - 1) / kAlignment * kAlignment;
    bytes_.resize(at + count * sizeof(T));
    std::memcpy(bytes_.data() + at, copy.data(), count * sizeof(T));
    return at;
  }

  const uintptr_t base_;
  std::vector<std::byte> bytes_;
  std::map<std::pair<const void*, size_t>, size_t> offsets_;  // byte offsets of the tables appended
                                                              // so far
};

// Returns the root's tables as bytes for the address `base`, which must be a multiple of 128.
// Afterwards `root` points to tables at that address.
template <class Root>
std::vector<std::byte> flatten(Root& root, uintptr_t base) {
  Flattener flattener(base);
  forTables(root, flattener);
  return flattener.take();
}

}  // namespace obby
