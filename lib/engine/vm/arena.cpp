#include "engine/vm/arena.h"

#include <sys/mman.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace obby::engine {
namespace {

constexpr uintptr_t kBase = 0x200000000000;  // far from all other mappings of a process
constexpr size_t kSmallest = 16;

}  // namespace

Arena::Arena(size_t capacity) : capacity_(capacity) {
  const int flags = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE;
  void* at = mmap(reinterpret_cast<void*>(kBase), capacity, PROT_READ | PROT_WRITE,
                  flags | MAP_FIXED_NOREPLACE, -1, 0);
  if (at == MAP_FAILED) at = mmap(nullptr, capacity, PROT_READ | PROT_WRITE, flags, -1, 0);
  if (at != MAP_FAILED) base_ = static_cast<char*>(at);
}

Arena::~Arena() {
  if (base_) munmap(base_, capacity_);
}

size_t Arena::classOf(size_t size) {
  if (size <= kSmallest) return 0;
  const size_t power = size_t(std::bit_width(size - 1)) - 1;  // 2^power < size <= 2^(power + 1)
  const size_t quarter = size_t(1) << (power - 2);
  const size_t steps = (size - (size_t(1) << power) + quarter - 1) / quarter;
  return (power - 4) * 4 + steps;
}

size_t Arena::sizeOf(size_t sizeClass) {
  const size_t power = sizeClass / 4 + 4;
  return (size_t(1) << power) + (sizeClass % 4) * (size_t(1) << (power - 2));
}

void* Arena::take(size_t sizeClass) {
  if (Free* const block = free_[sizeClass]) {
    free_[sizeClass] = block->next;
    return block;
  }
  const size_t size = (sizeOf(sizeClass) + kSmallest - 1) / kSmallest * kSmallest;
  if (size > capacity_ - used_) return nullptr;
  void* const block = base_ + used_;
  used_ += size;
  return block;
}

void Arena::give(void* block, size_t sizeClass) {
  Free* const node = static_cast<Free*>(block);
  node->next = free_[sizeClass];
  free_[sizeClass] = node;
}

void* Arena::resize(void* block, size_t oldSize, size_t newSize) {
  if (newSize == 0) {
    if (block) give(block, classOf(oldSize));
    return nullptr;
  }
  if (newSize > capacity_) return nullptr;
  const size_t sizeClass = classOf(newSize);
  if (!block) return take(sizeClass);
  const size_t oldClass = classOf(oldSize);
  if (oldClass == sizeClass) return block;
  void* const moved = take(sizeClass);
  // The VM assumes that shrinking a block cannot fail.
  if (!moved) return newSize < oldSize ? block : nullptr;
  std::memcpy(moved, block, std::min(oldSize, newSize));
  give(block, oldClass);
  return moved;
}

}  // namespace obby::engine
