// How much memory the tables take that a struct points to; flatten.h copies them.
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

// Of the root's tables and of those that they point to; what is shared counts once.
template <class Root>
size_t tableBytes(Root root) {
  TableBytes bytes;
  forTables(root, bytes);
  return bytes.bytes();
}

}  // namespace obby
