// Processes that train one network together, each with its own worlds. They add numbers in the
// order of ranks, so that the result depends only on the number of ranks. Every rank makes the same
// calls in the same order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace obby::train {

class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual uint32_t number() const = 0;  // number of this process
  virtual uint32_t count() const = 0;
  bool first() const { return number() == 0; }

  // `mine`: `size` bytes, the same size on every rank. `all`: (count, size), equal on every rank.
  virtual void exchange(const void* mine, size_t size, void* all) = 0;
  // Returns the first rank's `bytes` on every rank.
  virtual std::string share(std::string bytes) = 0;
  // Returns every rank's `bytes` in order on the first rank; an empty list on others.
  virtual std::vector<std::string> collect(std::string bytes) = 0;

  // Replaces the values by their sums over all ranks.
  void add(std::span<float> values);
  void add(std::span<double> values);

  // Returns the first rank's error on every rank, so that all go on or none does.
  Status agree(Status mine);
  template <class T>
  Result<T> agree(Result<T> mine) {
    OBBY_RETURN_IF_ERROR(agree(mine ? Status() : Status(mine.error())));
    return mine;
  }
};

// The rank of a run with one process.
class OneRank : public Ranks {
 public:
  uint32_t number() const override { return 0; }
  uint32_t count() const override { return 1; }
  void exchange(const void* mine, size_t size, void* all) override;
  std::string share(std::string bytes) override { return bytes; }
  std::vector<std::string> collect(std::string bytes) override { return {std::move(bytes)}; }
};

}  // namespace obby::train
