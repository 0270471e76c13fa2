// Counts the memory of the tables that a struct points to. flatten.h copies the same tables.
#pragma once

#include <cstddef>
#include <set>
#include <utility>

namespace obby {

class TableBytes {
 public:
  template <class T>
  void operator()(const T* table, size_t count) {
    if (table == nullptr || !counted_.insert({table, count * sizeof(T)}).second) return;
    bytes_ += count * sizeof(T);
    if constexpr (requires(T & element, TableBytes & b) { forTables(element, b); }) {
      for (size_t i = 0; i < count; ++i) {
        T element = table[i];
        forTables(element, *this);
      }
    }
  }
  size_t bytes() const { return bytes_; }

 private:
  std::set<std::pair<const void*, size_t>> counted_;
  size_t bytes_ = 0;
};

// Returns the bytes of the root's tables and of the tables they point to. A shared table counts
// once.
template <class Root>
size_t tableBytes(Root root) {
  TableBytes bytes;
  forTables(root, bytes);
  return bytes.bytes();
}

}  // namespace obby
