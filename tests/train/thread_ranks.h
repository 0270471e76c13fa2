// Ranks that are threads of the test instead of processes under MPI.
#pragma once

#include <algorithm>
#include <barrier>
#include <cstring>
#include <functional>
#include <thread>
#include <vector>

#include "train/ranks.h"

namespace obby::train {

class ThreadRanks {
 public:
  // Runs body(rank) on `count` ranks at the same time.
  static void run(uint32_t count, const std::function<void(Ranks&)>& body) {
    Meeting meeting(count);
    std::vector<std::thread> threads;
    for (uint32_t i = 0; i < count; ++i) {
      threads.emplace_back([&, i] {
        One rank(meeting, i);
        body(rank);
      });
    }
    for (std::thread& t : threads) t.join();
  }

 private:
  struct Meeting {
    explicit Meeting(uint32_t count) : given(count), barrier(ptrdiff_t(count)) {}
    std::vector<std::string> given;
    std::barrier<> barrier;
  };

  class One : public Ranks {
   public:
    One(Meeting& meeting, uint32_t number) : meeting_(meeting), number_(number) {}
    uint32_t number() const override { return number_; }
    uint32_t count() const override { return uint32_t(meeting_.given.size()); }
    void exchange(const void* mine, size_t size, void* all) override {
      const auto given = meet(std::string(static_cast<const char*>(mine), size));
      for (size_t i = 0; i < given.size(); ++i)
        std::memcpy(static_cast<char*>(all) + i * size, given[i].data(), size);
    }
    std::string share(std::string bytes) override { return meet(std::move(bytes))[0]; }
    std::vector<std::string> collect(std::string bytes) override {
      auto given = meet(std::move(bytes));
      return first() ? given : std::vector<std::string>();
    }

   private:
    std::vector<std::string> meet(std::string bytes) {
      meeting_.given[number_] = std::move(bytes);
      meeting_.barrier.arrive_and_wait();
      auto all = meeting_.given;
      meeting_.barrier.arrive_and_wait();
      return all;
    }

    Meeting& meeting_;
    uint32_t number_;
  };
};

}  // namespace obby::train
