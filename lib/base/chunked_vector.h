// A vector for tens of millions of elements. It grows by whole chunks that never move, so that
// growing never holds two copies of everything. Host only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <vector>

#include "base/check.h"

namespace obby {

template <class T>
class ChunkedVector {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  static constexpr size_t kChunk = size_t(1) << 16;  // elements

  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  T& operator[](size_t i) { return *at(i); }
  const T& operator[](size_t i) const { return *at(i); }

  // Returns the address of element i. The elements up to the next multiple of kChunk follow it.
  T* at(size_t i) { return chunks_[i / kChunk].get() + i % kChunk; }
  const T* at(size_t i) const { return chunks_[i / kChunk].get() + i % kChunk; }

  size_t chunkCount() const { return (size_ + kChunk - 1) / kChunk; }
  std::span<const T> chunk(size_t c) const {
    return {chunks_[c].get(), std::min(kChunk, size_ - c * kChunk)};
  }

  // Growth moves the elements only while there are fewer than kChunk of them.
  void push_back(const T& value) {
    if (size_ == capacity_) {
      const T kept = value;  // `value` may be an element that moves
      grow();
      *at(size_++) = kept;
      return;
    }
    *at(size_++) = value;
  }

  // Appends copies of `value`. `size` must not be below the present size.
  void resize(size_t size, const T& value = T{}) {
    OBBY_CHECK_LE(size_, size);
    const T kept = value;
    while (size_ < size) push_back(kept);
  }

  friend bool operator==(const ChunkedVector& a, const ChunkedVector& b) {
    if (a.size_ != b.size_) return false;
    for (size_t c = 0; c < a.chunkCount(); ++c) {
      if (!std::ranges::equal(a.chunk(c), b.chunk(c))) return false;
    }
    return true;
  }

 private:
  static constexpr size_t kFirst = 256;  // elements; small, so that a short search touches few
                                         // fresh pages

  struct Free {
    void operator()(T* chunk) const { ::operator delete(chunk, std::align_val_t(alignof(T))); }
  };
  using Chunk = std::unique_ptr<T, Free>;

  static Chunk allocate(size_t count) {
    return Chunk(static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t(alignof(T)))));
  }

  // The first chunk doubles; all others have their full size at once.
  void grow() {
    if (capacity_ >= kChunk) {
      chunks_.push_back(allocate(kChunk));
      capacity_ += kChunk;
      return;
    }
    capacity_ = std::max(kFirst, 2 * capacity_);
    Chunk larger = allocate(capacity_);
    if (chunks_.empty()) {
      chunks_.push_back(std::move(larger));
      return;
    }
    std::uninitialized_copy_n(chunks_[0].get(), size_, larger.get());
    chunks_[0] = std::move(larger);
  }

  std::vector<Chunk> chunks_;
  size_t size_ = 0, capacity_ = 0;
};

}  // namespace obby
