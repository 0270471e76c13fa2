// An allocator for large tables that are read in random order. On Linux it asks for 2 MiB pages, so
// that address translation costs less than the read. Elsewhere it only aligns to 2 MiB.
#pragma once

#include <cstddef>
#include <new>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace obby {

template <class T>
struct HugePages {
  using value_type = T;
  static constexpr std::align_val_t kPage{size_t(2) << 20};

  HugePages() = default;
  template <class U>
  HugePages(const HugePages<U>&) {}  // NOLINT(google-explicit-constructor)

  T* allocate(size_t count) {
    void* const memory = ::operator new(count * sizeof(T), kPage);
#if defined(__linux__)
    madvise(memory, count * sizeof(T), MADV_HUGEPAGE);  // a hint, which the system may refuse
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, size_t) { ::operator delete(memory, kPage); }

  friend bool operator==(const HugePages&, const HugePages&) { return true; }
};

}  // namespace obby
