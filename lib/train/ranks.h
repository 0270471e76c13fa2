// Processes that learn one network together, each with worlds of its own. Whatever they add up they
// add in the order of their numbers, so that the result depends on how many they are and on nothing
// else. Every rank makes the same calls in the same order.
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
  virtual uint32_t number() const = 0;  // of this one
  virtual uint32_t count() const = 0;
  bool first() const { return number() == 0; }

  // `mine`: `size` bytes, as many on every rank. `all`: (count, size), the same on every rank.
  virtual void exchange(const void* mine, size_t size, void* all) = 0;
  // What the first rank gives, on every rank.
  virtual std::string share(std::string bytes) = 0;
  // On the first rank what every rank gives, in their order; elsewhere nothing.
  virtual std::vector<std::string> collect(std::string bytes) = 0;

  // The values become their sums over all ranks.
  void add(std::span<float> values);
  void add(std::span<double> values);

  // The error of the first rank that has one, on every rank: all go on, or none does.
  Status agree(Status mine);
  template <class T>
  Result<T> agree(Result<T> mine) {
    OBBY_RETURN_IF_ERROR(agree(mine ? Status() : Status(mine.error())));
    return mine;
  }
};

// A process alone.
class OneRank : public Ranks {
 public:
  uint32_t number() const override { return 0; }
  uint32_t count() const override { return 1; }
  void exchange(const void* mine, size_t size, void* all) override;
  std::string share(std::string bytes) override { return bytes; }
  std::vector<std::string> collect(std::string bytes) override { return {std::move(bytes)}; }
};

}  // namespace obby::train
