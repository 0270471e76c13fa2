// The hardware that a search runs on.
#pragma once

#include "base/thread_pool.h"
#include "sim/device.h"

namespace obby::solve {

struct Machine {
  // Both must outlive the search.
  Machine(ThreadPool& threads, sim::Device* gpu = nullptr)  // NOLINT(google-explicit-constructor)
      : pool(threads), device(gpu) {}

  ThreadPool& pool;
  sim::Device* device;  // runs the rollouts; null: the pool does
};

}  // namespace obby::solve
